// SPDX-License-Identifier: MIT
// Asks the shaders' tracer about single rays: what is under the cursor, and does it agree with the
// oracle.
#pragma once

#include <span>
#include <vector>

#include "frame/pass_context.hpp"
#include "pack/pack_scene.hpp"

namespace vitrine {

struct QueryRay {
    glm::vec3 origin;     ///< world space, m
    float radius = 0;     ///< of the pixel's cone at the origin
    glm::vec3 direction;  ///< unit
    float length = 3.0e38f;
};

struct QueryCounts {
    uint64_t nodes = 0, steps = 0;
    uint32_t largestLoopCount = 0;
};

/// The rays of a query and what they have found, as images.
class RayImages {
  public:
    /// Uploads the rays, and sets `context` up for them: its picture's size and counters.
    void prepare(PassContext& context, std::span<const QueryRay> rays);
    void run(PassContext& context, const std::string& pass);
    /// A record a ray.
    [[nodiscard]] std::vector<glm::uvec4> read() const;
    [[nodiscard]] size_t count() const { return count_; }

  private:
    Texture origins_, directions_, records_;
    size_t count_ = 0;
};

class RayQuery {
  public:
    RayQuery(const Context& context, const PackedScene& scene, Backend backend,
             bool counters = false);

    /// A hit record a ray (pack/hit_record.hpp).
    std::vector<glm::uvec4> closest(std::span<const QueryRay> rays) {
        return ask("query_closest", rays);
    }
    /// A record of any surface on the way, or of a miss.
    std::vector<glm::uvec4> any(std::span<const QueryRay> rays) { return ask("query_any", rays); }

    /// Uploads the rays for runs of `repeat`, which draws and waits, to be timed.
    void prepare(std::span<const QueryRay> rays) { images_.prepare(context_, rays); }
    void repeat(bool anyHit);
    /// Of the last run; needs counters.
    [[nodiscard]] QueryCounts counts() const;

  private:
    std::vector<glm::uvec4> ask(const std::string& pass, std::span<const QueryRay> rays);

    PassContext context_;
    RayImages images_;
};

}  // namespace vitrine
