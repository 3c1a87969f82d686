// SPDX-License-Identifier: MIT
#include "frame/pass_probe_field.hpp"

#include <algorithm>

namespace vitrine {
namespace {

/// Samples lie in rows of an image this wide. A batch bounds the memory for parameters, and the
/// time of one draw: drivers kill those that take seconds.
constexpr int kImageWidth = 256;
constexpr int kImageHeight = 64;
constexpr size_t kBatch = size_t{kImageHeight} * kImageWidth;
/// The place, the tetrahedron, and two along the gradient (shaders/pass/probe_field.glsl).
constexpr int kEvaluations = 7;

}  // namespace

FieldProbe::FieldProbe(const Context& context, std::shared_ptr<const Snippet> field)
    : context_(
          context.info(),
          ProgramSet(context.info(), Backend::kAuto, generateShaders({std::move(field)}, {}), {}),
          false) {
    context_.block.counts = {0, kEvaluations, -1, VITRINE_LOOP_BUDGET};
}

std::vector<FieldValue> FieldProbe::ask(const FieldSamples& samples) {
    std::vector<FieldValue> values;
    values.reserve(samples.size());
    for (size_t first = 0; first < samples.size(); first += kBatch)
        askBatch(samples, first, std::min(kBatch, samples.size() - first), values);
    return values;
}

void FieldProbe::askBatch(const FieldSamples& samples, size_t first, size_t count,
                          std::vector<FieldValue>& values) {
    const int height = static_cast<int>((count + kImageWidth - 1) / kImageWidth);
    // All of one size: llvmpipe compiles anew for another kind of size.
    if (!places_.valid()) {
        for (Texture* t : {&places_, &steps_, &values_, &gradients_})
            *t = Texture(kImageWidth, kImageHeight, TexelFormat::kRgba32f);
    }
    std::vector<glm::vec4> places(kBatch, glm::vec4(0));
    std::vector<glm::vec4> steps(places.size(), glm::vec4(1, 0, 0, 0));
    for (size_t i = 0; i < count; ++i) {
        const FieldSamples::Place& place = samples.places[first + i];
        places[i] = glm::vec4(place.point, place.time);
        // Exact as a float: a batch has at most 2^14 samples of 2^6 parameters.
        steps[i] = glm::vec4(place.step, static_cast<float>(i * samples.settingSize), 0, 0);
    }
    places_.write(std::as_bytes(std::span(places)));
    steps_.write(std::as_bytes(std::span(steps)));
    const std::span parameters(samples.parameters);
    context_.scene.tables.upload(std::as_bytes(
        parameters.subspan(first * samples.settingSize, count * samples.settingSize)));
    context_.block.image = {kImageWidth, kImageHeight, 0, 0};
    context_.rows = {0, height};
    context_.run("probe_field", {{{"samplePlaces", &places_}, {"sampleSteps", &steps_}},
                                 {},
                                 {{"outValue", &values_}, {"outGradient", &gradients_}}});
    const std::vector<float> answers = values_.readFloats();
    const std::vector<float> gradients = gradients_.readFloats();
    for (size_t i = 0; i < count; ++i) {
        const float* a = answers.data() + 4 * i;
        const float* g = gradients.data() + 4 * i;
        values.push_back({a[0], a[1], {g[0], g[1], g[2]}, static_cast<int>(a[2])});
    }
}

}  // namespace vitrine
