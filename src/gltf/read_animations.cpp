// SPDX-License-Identifier: MIT
#include "gltf/read_animations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vitrine {
namespace {

struct Sampler {
    const Accessor* input = nullptr;
    const Accessor* output = nullptr;
    GltfInterpolation interpolation = GltfInterpolation::kLinear;
    [[nodiscard]] uint64_t valuesPerKey() const {
        return interpolation == GltfInterpolation::kCubicSpline ? 3 : 1;
    }
};

class AnimationReader {
  public:
    AnimationReader(ReadContext& context, const Accessors& accessors)
        : context_(context), accessors_(accessors) {}

    GltfAnimation read(const JsonValue& animation, size_t number) {
        GltfAnimation result{nameOf(animation, "animation", number), {}, 0};
        const JsonValue samplers = animation.array("samplers");
        const JsonValue channels = animation.array("channels");
        for (size_t i = 0; i < channels.size(); ++i) {
            const JsonValue value = channels.objectAt(i);
            GltfChannel channel;
            if (!readTarget(value.object("target"), channel)) continue;
            if (!value.has("sampler")) value.error("'sampler' is missing");
            const int index = value.index("sampler", samplers.size());
            if (index == kNoIndex || !readSampler(samplers.objectAt(index), channel)) continue;
            result.duration = std::max(result.duration, channel.times.back());
            result.channels.push_back(std::move(channel));
        }
        return result;
    }

  private:
    /// False if the channel is to be left out, for whatever reason.
    bool readTarget(const JsonValue& target, GltfChannel& channel) const {
        channel.node = target.index("node", context_.model.nodes.size());
        const std::string path = target.text("path");
        if (path == "translation") {
            channel.path = GltfPath::kTranslation;
        } else if (path == "rotation") {
            channel.path = GltfPath::kRotation;
        } else if (path == "scale") {
            channel.path = GltfPath::kScale;
        } else if (path == "weights") {
            target.warnOnce("morph targets are not supported; their animation is left out");
            return false;
        } else {
            target.warning("path", inQuotes(path) + " cannot be animated; left out");
            return false;
        }
        if (channel.node == kNoIndex) return false;
        if (!context_.model.nodes[channel.node].matrix) return true;
        target.warning("left out: a node with a matrix cannot be animated");
        return false;
    }

    bool readSampler(const JsonValue& value, GltfChannel& channel) {
        Sampler sampler{accessors_.find(value, "input"), accessors_.find(value, "output"),
                        readInterpolation(value)};
        for (const char* key : {"input", "output"})
            if (value.exists() && !value.has(key)) value.error(fmt::format("'{}' is missing", key));
        if (sampler.input == nullptr || sampler.output == nullptr ||
            !isGoodInput(value, *sampler.input) || !isGoodOutput(value, sampler, channel.path))
            return false;
        channel.interpolation = sampler.interpolation;
        const uint64_t keys = sampler.input->count, values = keys * sampler.valuesPerKey();
        if (!context_.spend(&GltfLimits::animationNumbers, keys + 4 * values,
                            "numbers in animations", value))
            return false;
        for (const auto& time : sampler.input->read<1>(0, sampler.input->count))
            channel.times.push_back(time.x);
        channel.values = sampler.output->read<4>(0, sampler.output->count);
        return areUsable(value, channel);
    }

    static GltfInterpolation readInterpolation(const JsonValue& sampler) {
        if (!sampler.has("interpolation")) return GltfInterpolation::kLinear;
        const std::string name = sampler.text("interpolation");
        if (name == "STEP") return GltfInterpolation::kStep;
        if (name == "CUBICSPLINE") return GltfInterpolation::kCubicSpline;
        if (name != "LINEAR")
            sampler.error("interpolation",
                          inQuotes(name) + " is none of LINEAR, STEP and CUBICSPLINE");
        return GltfInterpolation::kLinear;
    }

    static bool isGoodInput(const JsonValue& sampler, const Accessor& input) {
        if (input.components == 1 && input.type == ComponentType::kFloat) return true;
        sampler.error("input", "the accessor must be a SCALAR of floats");
        return false;
    }

    static bool isGoodOutput(const JsonValue& sampler, const Sampler& s, GltfPath path) {
        const Accessor& output = *s.output;
        const int components = path == GltfPath::kRotation ? 4 : 3;
        const bool isFloat = output.type == ComponentType::kFloat;
        std::string problem;
        if (output.isMatrix || output.components != components)
            problem = fmt::format("the accessor must be a VEC{}", components);
        else if (!isFloat && !(path == GltfPath::kRotation && output.isNormalized))
            problem = "the accessor's type is not allowed here";
        else if (output.count != s.input->count * s.valuesPerKey())
            problem = fmt::format("{} elements for {} times; {} a time are needed", output.count,
                                  s.input->count, s.valuesPerKey());
        else if (s.interpolation == GltfInterpolation::kCubicSpline && s.input->count < 2)
            problem = "a cubic spline needs two times at least";
        if (problem.empty()) return true;
        sampler.error("output", problem);
        return false;
    }

    static bool areUsable(const JsonValue& sampler, const GltfChannel& channel) {
        const auto isFiniteFloat = [](float x) { return std::isfinite(x); };
        std::string problem;
        if (!std::all_of(channel.times.begin(), channel.times.end(), isFiniteFloat) ||
            std::adjacent_find(channel.times.begin(), channel.times.end(),
                               std::greater_equal<>()) != channel.times.end())
            problem = "the times do not grow";
        for (const glm::vec4& v : channel.values)
            if (!isFiniteFloat(v.x) || !isFiniteFloat(v.y) || !isFiniteFloat(v.z) ||
                !isFiniteFloat(v.w))
                problem = "a value is not a finite number";
        if (problem.empty()) return true;
        sampler.warning("the animation of one property is left out: " + problem);
        return false;
    }

    ReadContext& context_;
    const Accessors& accessors_;
};

}  // namespace

void readAnimations(ReadContext& context, const Accessors& accessors) {
    const JsonValue animations = context.root.array("animations");
    AnimationReader reader(context, accessors);
    for (size_t i = 0; i < animations.size(); ++i)
        context.model.animations.push_back(reader.read(animations.objectAt(i), i));
}

}  // namespace vitrine
