// SPDX-License-Identifier: MIT
// What `info` says about the tree of a mesh.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "pack/assets.hpp"

namespace vitrine {

/// The mesh and its tree; with `builders`, under that key, also the trees of all builders, which
/// are built for it.
nlohmann::ordered_json describeMesh(const std::string& shape, const MeshAsset& asset,
                                    const TreeSettings& settings, bool builders);

/// A line, and a table of the builders if there are any.
void printMesh(const nlohmann::ordered_json& mesh);

}  // namespace vitrine
