// SPDX-License-Identifier: MIT
// The programs of the passes, compiled when first used. All variants there are stand in one list,
// which a test compiles for every dialect without a GPU.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "gpu/context.hpp"
#include "gpu/program.hpp"
#include "pack/pack_scene.hpp"

namespace vitrine {

enum class Backend { kAuto, kFragment, kCompute };

/// What a scene needs of its programs.
struct ProgramFeatures {
    bool meshes = true;
    bool fields = true;
    bool counters = false;
    bool textures = false;
    bool layers = false;        ///< varnish, sheen
    bool transmission = false;  ///< glass
    bool subsurface = false;    ///< light that comes through, scattered
    bool classic = false;       ///< materials that are lambert or blinn-phong
    bool curvature = false;     ///< material snippets that ask for it
    bool sky = false;           ///< a picture of it
    bool filters = false;       ///< surfaces that let rays pass
    bool culling = false;       ///< meshes not seen from behind
    bool vertexExtras = false;  ///< second texture coordinates or colours of vertices
    bool tangents = false;
    bool cones = false;  ///< shadow rays mind what they pass
    /// Fields are seen, but by no light and in no mirror: none of the long programs has the text of
    /// a field in it, and all but the first hits is compiled already when a field has changed.
    bool sketch = false;
    bool operator==(const ProgramFeatures&) const = default;
};
ProgramFeatures featuresOf(const PackedScene& scene, bool counters, bool sketch = false);

/// A pass's shader under the features that concern it, for any stage and dialect.
ShaderKey shaderKey(const std::string& pass, const ProgramFeatures& features, ShaderStage stage,
                    Dialect dialect);
/// The generated text for this pass: drivers know a program again by all of its text, also by that
/// which is switched off, so a sketch has none of what it does not need.
GeneratedIncludes includesOf(const std::string& pass, const ProgramFeatures& features,
                             const GeneratedShaders& shaders);
/// Names of the passes' shaders, whether a pass traces rays (and so has variants), and whether it
/// draws triangles instead of covering the picture.
struct PassShader {
    std::string name;
    bool traces = false;
    bool raster = false;
};
const std::vector<PassShader>& passShaders();
const PassShader& findPass(const std::string& name);

/// In the place of a field's number.
inline constexpr int kAllFields = -1;

class ProgramSet {
  public:
    /// `backend` must be possible on this context; kAuto takes compute on a GPU that has it and
    /// fragment elsewhere (software drivers spread fragment work better over the cores).
    ProgramSet(const GpuInfo& gpu, Backend backend, GeneratedShaders shaders,
               ProgramFeatures features);

    /// `onlyField`: the program knows this field and no other.
    /// Throws InputError, placed in the user's snippet, if a snippet does not compile, and
    /// std::logic_error with the place if one of our own shaders does not.
    const Program& get(const std::string& pass, int onlyField = kAllFields);
    /// Whether the programs can do what this moment needs.
    [[nodiscard]] bool covers(const PackedMoment& moment) const {
        return joined(moment) == features_;
    }
    /// From now on the programs can do what this moment needs besides what they could.
    void require(const PackedMoment& moment);
    /// To be called before each program is compiled. What it throws leaves the set as it is.
    void callBefore(std::function<void()> call) { before_ = std::move(call); }
    [[nodiscard]] Backend backend() const { return backend_; }
    [[nodiscard]] double compileSeconds() const { return compileSeconds_; }

  private:
    [[nodiscard]] ProgramFeatures joined(const PackedMoment& moment) const;
    const GpuInfo gpu_;
    Backend backend_;
    GeneratedShaders shaders_;
    ProgramFeatures features_;
    std::map<std::string, Program> programs_;
    std::function<void()> before_;
    double compileSeconds_ = 0;
};

/// What a compiler said, in the terms of the user's files; empty if no snippet is to blame.
Diagnostics explainShaderError(const ShaderError& error, const GeneratedShaders& shaders);

}  // namespace vitrine
