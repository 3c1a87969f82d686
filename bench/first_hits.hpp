// SPDX-License-Identifier: MIT
// The finders of first hits, in turn: the rasteriser with the boxes of the fields, the rasteriser
// with the tree over the fields, and the tracer.
#pragma once

#include <array>

#include "frame/first_hits.hpp"
#include "gpu/context.hpp"
#include "pack/camera.hpp"
#include "stopwatch.hpp"

namespace vitrine {

class FirstHits {
  public:
    FirstHits(const Context& gpu, const PackedScene& packed, const Camera& camera, int width,
              int height)
        : watch_(gpu.info().software),
          context_(
              gpu.info(),
              ProgramSet(gpu.info(), Backend::kAuto, packed.shaders, featuresOf(packed, false)),
              false),
          instances_(packed.instances),
          fieldRoot_(packed.fieldRoot),
          records_(width, height, TexelFormat::kRgba32ui),
          spare_(width, height, TexelFormat::kRgba32ui),
          depth_(width, height) {
        context_.scene.upload(packed);
        context_.block = packed.block;
        packCamera(camera, width, height, context_.block);
    }

    /// How many times over the boxes of the fields cover the picture.
    [[nodiscard]] float cover() const { return fieldBoxes(context_.block, instances_).cover; }

    /// Medians: seconds, and ratios to the boxes. The first run of each compiles.
    struct Result {
        double boxes = 0, tree = 0, trace = 0;
        double boxesFirst = 0, treeFirst = 0, traceFirst = 0;
        double treeRatio = 0, traceRatio = 0;
    };
    Result compare(int rounds) {
        std::array<std::vector<double>, 3> seconds;
        std::vector<double> treeRatios, traceRatios;
        Result result;
        for (int round = -1; round < rounds; ++round) {
            const double a = watch_.secondsOf([&] { raster(FieldFinder::kBoxes); });
            const double b = watch_.secondsOf([&] { raster(FieldFinder::kTree); });
            const double c = watch_.secondsOf([&] { trace(); });
            if (round < 0) {
                result.boxesFirst = a;
                result.treeFirst = b;
                result.traceFirst = c;
                continue;
            }
            seconds[0].push_back(a);
            seconds[1].push_back(b);
            seconds[2].push_back(c);
            treeRatios.push_back(b / a);
            traceRatios.push_back(c / a);
        }
        result.boxes = median(seconds[0]);
        result.tree = median(seconds[1]);
        result.trace = median(seconds[2]);
        result.treeRatio = median(treeRatios);
        result.traceRatio = median(traceRatios);
        return result;
    }

  private:
    void raster(FieldFinder finder) {
        rasterFirstHits(context_, instances_, fieldRoot_, finder, depth_, spare_, records_);
        finishGpu();
    }
    void trace() {
        visibilityPass(context_, records_);
        finishGpu();
    }

    Stopwatch watch_;
    PassContext context_;
    std::vector<PackedInstance> instances_;
    int fieldRoot_;
    Texture records_, spare_;
    DepthImage depth_;
};

}  // namespace vitrine
