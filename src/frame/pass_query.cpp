// SPDX-License-Identifier: MIT
#include "frame/pass_query.hpp"

#include <algorithm>

#include "gpu/context.hpp"

namespace vitrine {
namespace {

/// Rays lie in rows of an image this wide.
constexpr int kImageWidth = 512;

}  // namespace

RayQuery::RayQuery(const Context& context, const PackedScene& scene, Backend backend, bool counters)
    : context_(context.info(),
               ProgramSet(context.info(), backend, scene.shaders, featuresOf(scene, counters)),
               counters) {
    context_.scene.upload(scene);
    context_.block = scene.block;
}

void RayImages::prepare(PassContext& context, std::span<const QueryRay> rays) {
    count_ = rays.size();
    const int height = std::max(1, static_cast<int>((rays.size() + kImageWidth - 1) / kImageWidth));
    if (height != records_.height()) {
        origins_ = Texture(kImageWidth, height, TexelFormat::kRgba32f);
        directions_ = Texture(kImageWidth, height, TexelFormat::kRgba32f);
        records_ = Texture(kImageWidth, height, TexelFormat::kRgba32ui);
    }
    // Somebody else may have used the counters since.
    if (context.counters[0].width() != kImageWidth || context.counters[0].height() != height)
        for (Texture& t : context.counters)
            t = Texture(kImageWidth, height, TexelFormat::kRgba32ui);
    // What is left of the last row has no length, and so ends at once.
    std::vector<glm::vec4> origins(static_cast<size_t>(kImageWidth) * height, glm::vec4(0));
    std::vector<glm::vec4> directions(origins.size(), glm::vec4(0, 0, 1, 0));
    for (size_t i = 0; i < rays.size(); ++i) {
        origins[i] = glm::vec4(rays[i].origin, rays[i].radius);
        directions[i] = glm::vec4(rays[i].direction, rays[i].length);
    }
    origins_.write(std::as_bytes(std::span(origins)));
    directions_.write(std::as_bytes(std::span(directions)));
    context.block.image.x = kImageWidth;
    context.block.image.y = height;
}

void RayImages::run(PassContext& context, const std::string& pass) {
    context.run(pass, {{{"rayOrigins", &origins_}, {"rayDirections", &directions_}},
                       {},
                       {{"outRecord", &records_}}});
}

std::vector<glm::uvec4> RayImages::read() const {
    const std::vector<uint32_t> texels = records_.readUints();
    std::vector<glm::uvec4> records(count_);
    for (size_t i = 0; i < records.size(); ++i)
        records[i] = {texels[4 * i], texels[4 * i + 1], texels[4 * i + 2], texels[4 * i + 3]};
    return records;
}

void RayQuery::repeat(bool anyHit) {
    images_.run(context_, anyHit ? "query_any" : "query_closest");
    finishGpu();
}

std::vector<glm::uvec4> RayQuery::ask(const std::string& pass, std::span<const QueryRay> rays) {
    prepare(rays);
    images_.run(context_, pass);
    return images_.read();
}

QueryCounts RayQuery::counts() const {
    QueryCounts counts;
    const std::vector<uint32_t> texels = context_.counters[0].readUints();
    for (size_t i = 0; i < 4 * images_.count(); i += 4) {
        counts.largestLoopCount = std::max(counts.largestLoopCount, texels[i]);
        counts.nodes += texels[i + 1];
        counts.steps += texels[i + 2];
    }
    return counts;
}

}  // namespace vitrine
