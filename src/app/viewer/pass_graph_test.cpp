// SPDX-License-Identifier: MIT
#include "app/viewer/pass_graph.hpp"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

TEST(PassGraph, ShowsWhatSumsHaveGrownBy) {
    EXPECT_EQ(difference({{"light", 2.0}, {"raster", 1.0}}, {}),
              (PassSeconds{{"light", 2.0}, {"raster", 1.0}}));
    EXPECT_EQ(difference({{"light", 5.0}, {"raster", 1.0}}, {{"light", 2.0}}),
              (PassSeconds{{"light", 3.0}, {"raster", 1.0}}));
}

TEST(PassGraph, ForgetsTheOldest) {
    PassGraph graph;
    for (size_t i = 0; i < PassGraph::kMostSamples + 2; ++i)
        graph.add({{"light", static_cast<double>(i)}});
    ASSERT_EQ(graph.samples().size(), PassGraph::kMostSamples);
    EXPECT_EQ(graph.samples().front().at("light"), 2.0);
}

}  // namespace
}  // namespace vitrine
