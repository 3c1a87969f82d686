// SPDX-License-Identifier: MIT
// The one list of a mesh's arrays with one entry a vertex: whoever moves, copies or drops vertices
// goes through it, so that no array falls out of step.
#pragma once

#include "mesh/mesh.hpp"

namespace vitrine {

/// Calls `visit(array)` for each; optional arrays only if the mesh has them.
template <typename Visit>
void forEachVertexArray(Mesh& mesh, const Visit& visit) {
    visit(mesh.positions);
    visit(mesh.normals);
    visit(mesh.uvs);
    if (!mesh.uvs2.empty()) visit(mesh.uvs2);
    if (!mesh.colors.empty()) visit(mesh.colors);
    if (!mesh.tangents.empty()) visit(mesh.tangents);
}

}  // namespace vitrine
