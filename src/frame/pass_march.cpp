// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "frame/in_view.hpp"
#include "frame/passes.hpp"
#include "pack/camera.hpp"

namespace vitrine {
namespace {

/// The first so many fields of a scene have programs of their own, in which no other field is
/// evaluated; each takes about a tenth of a second to compile. The others share one.
constexpr int kOwnPrograms = 8;

/// Of the cube from -1 to 1: the rear of such a box covers all of the picture, as near as can be.
glm::mat4 wholePicture() {
    return {{2, 0, 0, 0}, {0, 2, 0, 0}, {0, 0, 0, 0}, {0, 0, 1, 1}};
}

/// The projection, but with what `nearest` (m, along the camera's axis) has, or a little more, in
/// the place of depth, z / w. It clips what is nearer than a thousandth of that.
glm::mat4 asIfNear(glm::mat4 clipFromWorld, float nearest) {
    const float depth = 1.001f * VITRINE_NEAR_PLANE / nearest, end = 1e-3f * nearest;
    // z = depth (w - end) + end, so that z <= w from w = end on.
    for (int column = 0; column < 4; ++column)
        clipFromWorld[column].z = depth * clipFromWorld[column].w;
    clipFromWorld[3].z += (1 - depth) * end;
    return clipFromWorld;
}

struct PlacedBox {
    float nearest;  ///< least distance from the eye, m
    glm::mat4 clipFromBox;
    bool whole = false;  ///< the whole picture is drawn
};

/// The box, larger by a hair, so that the shader and not the rasteriser decides which pixels it
/// has; or the whole picture where the eye stands in it, or so near that its corners are out of all
/// proportion.
PlacedBox placeBox(const PackedInstance& instance, const FrameBlock& block,
                   const glm::mat4& clipFromWorld) {
    constexpr float kPixels = 0.05f;      // larger, where it is farthest
    constexpr float kProportion = 1e-3f;  // of the nearest distance to the farthest
    const glm::vec3 eye(block.cameraEye);
    const float farthest = farthestDistance(instance.worldBox, eye);
    const glm::mat4 objectFromWorld = glm::inverse(instance.worldFromObject);
    const glm::vec3 local(objectFromWorld * glm::vec4(eye, 1));
    const glm::vec3 centre = instance.objectBox.centre();
    glm::vec3 half = 0.5f * instance.objectBox.extent();
    float nearest = 0;
    for (int axis = 0; axis < 3; ++axis) {
        // How much the coordinate grows by on a metre square to the box's sides.
        const float perMetre = glm::length(glm::vec3(
            objectFromWorld[0][axis], objectFromWorld[1][axis], objectFromWorld[2][axis]));
        half[axis] += kPixels * block.cameraEye.w * farthest * perMetre;
        nearest = std::max(nearest, (std::abs(local[axis] - centre[axis]) - half[axis]) / perMetre);
    }
    const float widest = std::sqrt(1 + block.cameraRight.w + block.cameraUp.w);
    const float nearestDepth = nearest / widest;
    if (nearest < kProportion * farthest || nearestDepth < 2 * VITRINE_NEAR_PLANE)
        return {nearest, wholePicture(), true};
    // In a mirror a box is the same box, but inside out: mirrored once more, it is right again.
    if (glm::determinant(glm::mat3(instance.worldFromObject)) < 0) half.x = -half.x;
    const glm::mat4 objectFromBox(glm::vec4(half.x, 0, 0, 0), glm::vec4(0, half.y, 0, 0),
                                  glm::vec4(0, 0, half.z, 0), glm::vec4(centre, 1));
    return {nearest,
            asIfNear(clipFromWorld, nearestDepth) * instance.worldFromObject * objectFromBox};
}

/// The part of the picture that the box takes, or somewhat more: its bounds there.
float coverOf(const glm::mat4& clipFromBox) {
    glm::vec2 low(1), high(-1);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec4 p =
            clipFromBox * glm::vec4((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                                    (corner & 4) != 0 ? 1 : -1, 1);
        if (p.w <= 0) return 1;  // it reaches behind the eye
        const glm::vec2 at = glm::clamp(glm::vec2(p) / p.w, -1.0f, 1.0f);
        low = glm::min(low, at);
        high = glm::max(high, at);
    }
    return 0.25f * (high.x - low.x) * (high.y - low.y);
}

/// What was added up in floats (pass/march.glsl) replaces the counters (shade/counters.glsl).
void takeCounts(const Texture& sums, Texture& counters) {
    const std::vector<float> from = sums.readFloats();
    std::vector<uint32_t> texels(from.size(), 0);
    for (size_t i = 0; i < from.size(); i += 4) {
        texels[i] = static_cast<uint32_t>(from[i + 3]);
        texels[i + 2] = static_cast<uint32_t>(from[i + 1]);
    }
    counters.write(std::as_bytes(std::span(texels)));
}

}  // namespace

FieldBoxes fieldBoxes(const FrameBlock& block, std::span<const PackedInstance> instances) {
    const glm::mat4 clipFromWorld = packProjection(block);
    FieldBoxes boxes;
    std::vector<std::pair<float, BoxDraw>> order;
    for (size_t i = 0; i < instances.size(); ++i) {
        const PackedInstance& instance = instances[i];
        if (!instance.field || isOutside(instance.worldBox, clipFromWorld)) continue;
        const PlacedBox box = placeBox(instance, block, clipFromWorld);
        order.push_back({box.nearest, {box.clipFromBox, static_cast<int>(i)}});
        if (!box.whole) boxes.cover += coverOf(box.clipFromBox);
    }
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [distance, draw] : order) {
        const int snippet = instances[static_cast<size_t>(draw.instance)].snippet;
        const int field = snippet < kOwnPrograms ? snippet : kAllFields;
        auto group = std::find_if(boxes.groups.begin(), boxes.groups.end(),
                                  [field](const FieldBoxes::Group& g) { return g.field == field; });
        if (group == boxes.groups.end()) group = boxes.groups.insert(group, {field, {}});
        group->boxes.push_back(draw);
    }
    return boxes;
}

void marchPass(PassContext& context, const FieldBoxes& boxes, const DepthImage& depth, bool first,
               Texture& records) {
    context.block.sampling.z = 0;
    for (const FieldBoxes::Group& group : boxes.groups) {
        context.drawBoxes("march", group.field, {{}, {"outRecord", &records}, {}, &depth},
                          first ? BoxTarget::kNearestCleared : BoxTarget::kNearest, group.boxes);
        first = false;
    }
    if (!context.counting) return;
    Texture sums(records.width(), records.height(), TexelFormat::kRgba32f);
    sums.clear();
    for (const FieldBoxes::Group& group : boxes.groups)
        context.drawBoxes("march_counters", group.field, {{}, {"outCounters", &sums}, {}, nullptr},
                          BoxTarget::kSum, group.boxes);
    takeCounts(sums, context.counters[0]);
}

}  // namespace vitrine
