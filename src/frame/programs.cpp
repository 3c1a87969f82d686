// SPDX-License-Identifier: MIT
#include "frame/programs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace vitrine {
namespace {

Backend chooseBackend(const GpuInfo& gpu, Backend wanted) {
    if (wanted == Backend::kCompute && !gpu.compute)
        throw MachineError(
            fmt::format("'{}' has no compute shaders; use --backend fragment", gpu.renderer));
    if (wanted != Backend::kAuto) return wanted;
    return gpu.compute && !gpu.software ? Backend::kCompute : Backend::kFragment;
}

bool isSketched(const std::string& pass, const ProgramFeatures& features) {
    return features.sketch && (pass == "light" || pass == "bounce");
}

/// The log with places in our own files, for whoever writes shaders here.
std::string describeOwnError(const ShaderError& error) {
    std::string text = error.what();
    for (const CompileMessage& message : parseCompileLog(error.log)) {
        const auto line = static_cast<size_t>(message.line);
        if (line >= 1 && line <= error.places.size())
            text += fmt::format("{}: {}\n", error.places[line - 1].text(), message.message);
    }
    return text;
}

}  // namespace

const std::vector<PassShader>& passShaders() {
    static const std::vector<PassShader> passes{
        {"raster", false, true},  {"march", true, true},       {"march_counters", true, true},
        {"visibility", true},     {"visibility_fields", true}, {"light", true},
        {"bounce", true},         {"accumulate", false},       {"display", false},
        {"view", false},          {"layers", false},           {"boxes", false, true},
        {"focus_levels", false},  {"focus_reach", false},      {"focus", false},
        {"check_snippet", false}, {"probe_field", false},      {"query_closest", true},
        {"query_any", true}};
    return passes;
}

const PassShader& findPass(const std::string& name) {
    const auto& passes = passShaders();
    const auto found = std::find_if(passes.begin(), passes.end(),
                                    [&](const PassShader& p) { return p.name == name; });
    if (found == passes.end()) throw std::logic_error("there is no pass " + name);
    return *found;
}

ProgramFeatures featuresOf(const PackedScene& scene, bool counters, bool sketch) {
    ProgramFeatures features;
    features.meshes = scene.hasMeshes;
    features.fields = scene.hasFields;
    features.counters = counters;
    features.sketch = sketch;
    features.textures = scene.textures.any();
    features.layers = scene.hasLayers;
    features.subsurface = scene.hasSubsurface;
    features.classic = scene.hasClassic;
    features.curvature = scene.hasCurvature;
    features.vertexExtras = scene.hasVertexExtras;
    features.tangents = scene.hasTangents;
    features.transmission = scene.hasTransmission;
    features.sky = scene.sky != nullptr;
    features.filters = scene.hasFilters;
    features.culling = scene.hasCulling;
    features.cones = scene.hasCones;
    return features;
}

ShaderKey shaderKey(const std::string& pass, const ProgramFeatures& features, ShaderStage stage,
                    Dialect dialect) {
    ShaderKey key{pass, stage, dialect, {}};
    const bool traces = findPass(pass).traces;
    // What is drawn over itself cannot count in the same run as it finds.
    const bool counts = pass == "march_counters" || (features.counters && pass != "march");
    key.defines["COUNTERS"] = traces && counts ? 1 : 0;
    const bool sketched = isSketched(pass, features);
    key.defines["HAS_TEXTURES"] = features.textures ? 1 : 0;
    key.defines["HAS_LAYERS"] = features.layers ? 1 : 0;
    key.defines["HAS_TRANSMISSION"] = features.transmission ? 1 : 0;
    key.defines["HAS_SUBSURFACE"] = features.subsurface ? 1 : 0;
    key.defines["HAS_CLASSIC"] = features.classic ? 1 : 0;
    key.defines["HAS_CURVATURE"] = features.curvature ? 1 : 0;
    key.defines["HAS_SKY"] = features.sky ? 1 : 0;
    key.defines["HAS_FILTERS"] = (traces || pass == "raster") && features.filters ? 1 : 0;
    key.defines["HAS_VERTEX_EXTRAS"] = features.vertexExtras ? 1 : 0;
    key.defines["HAS_TANGENTS"] = features.textures && features.tangents ? 1 : 0;
    if (traces) {
        key.defines["HAS_CULLING"] = features.culling ? 1 : 0;
        key.defines["HAS_CONES"] = pass == "light" && features.cones && !sketched ? 1 : 0;
        const bool meshes = features.meshes && pass != "visibility_fields";
        key.defines["HAS_MESHES"] = meshes ? 1 : 0;
        key.defines["HAS_FIELDS"] = features.fields && !sketched ? 1 : 0;
    }
    return key;
}

GeneratedIncludes includesOf(const std::string& pass, const ProgramFeatures& features,
                             const GeneratedShaders& shaders) {
    GeneratedIncludes includes = shaders.includes;
    if (isSketched(pass, features)) includes["generated/field.glsl"].clear();
    return includes;
}

ProgramSet::ProgramSet(const GpuInfo& gpu, Backend backend, GeneratedShaders shaders,
                       ProgramFeatures features)
    : gpu_(gpu),
      backend_(chooseBackend(gpu, backend)),
      shaders_(std::move(shaders)),
      features_(features) {}

ProgramFeatures ProgramSet::joined(const PackedMoment& moment) const {
    ProgramFeatures all = features_;
    all.layers |= moment.hasLayers;
    all.transmission |= moment.hasTransmission;
    all.subsurface |= moment.hasSubsurface;
    all.classic |= moment.hasClassic;
    all.curvature |= moment.hasCurvature;
    all.filters |= moment.hasFilters;
    all.culling |= moment.hasCulling;
    all.cones |= moment.hasCones;
    return all;
}

void ProgramSet::require(const PackedMoment& moment) {
    if (covers(moment)) return;
    features_ = joined(moment);
    programs_.clear();
}

const Program& ProgramSet::get(const std::string& pass, int onlyField) {
    const std::string name = fmt::format("{} {}", pass, onlyField);
    const auto known = programs_.find(name);
    if (known != programs_.end()) return known->second;
    if (before_) before_();
    const auto start = std::chrono::steady_clock::now();
    const Dialect dialect = gpu_.glslVersion >= 450 ? Dialect::kGl450 : Dialect::kGl410;
    const bool raster = findPass(pass).raster;
    const bool compute = backend_ == Backend::kCompute && !raster;
    ShaderKey key = shaderKey(pass, features_,
                              compute ? ShaderStage::kCompute : ShaderStage::kFragment, dialect);
    if (onlyField != kAllFields) key.defines["ONLY_FIELD"] = onlyField;
    const GeneratedIncludes includes = includesOf(pass, features_, shaders_);
    try {
        Program program = raster    ? Program::raster(key, includes)
                          : compute ? Program::compute(key, includes)
                                    : Program::fragment(key, includes);
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        compileSeconds_ += elapsed.count();
        return programs_[name] = std::move(program);
    } catch (const ShaderError& error) {
        explainShaderError(error, shaders_).throwIfErrors();
        throw std::logic_error(describeOwnError(error));
    }
}

Diagnostics explainShaderError(const ShaderError& error, const GeneratedShaders& shaders) {
    std::vector<SnippetInProgram> snippets;
    for (const EmittedSnippet& emitted : shaders.snippets)
        snippets.push_back({emitted.snippet.get(), &emitted.options});
    Diagnostics diagnostics;
    for (const CompileMessage& message : parseCompileLog(error.log)) {
        if (message.severity != Severity::kError) continue;
        if (auto explained = explainMessage(message, snippets)) diagnostics.add(*explained);
    }
    return diagnostics;
}

}  // namespace vitrine
