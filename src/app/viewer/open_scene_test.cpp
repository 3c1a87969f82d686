// SPDX-License-Identifier: MIT
#include "app/viewer/open_scene.hpp"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

TEST(OpenScene, TakesScenesModelsAndFieldsByTheirNames) {
    for (const char* file : {"a.toml", "/b c/a.glb", "a.gltf", "a.obj", "a.sdf.glsl"})
        EXPECT_TRUE(canOpen(file)) << file;
    for (const char* file : {"a.png", "a.mat.glsl", "a.glsl", "a.toml.txt", "toml", ""})
        EXPECT_FALSE(canOpen(file)) << file;
}

TEST(OpenScene, TellsNumbersFromWhatMustBeReadAgain) {
    EXPECT_TRUE(changesOnlyNumbers({"node.a.at=[0,0,0]"}, {"node.a.at=[1,0,0]", "render.ao=1"}));
    EXPECT_FALSE(changesOnlyNumbers({}, {"environment.turbidity=3"}));
    EXPECT_FALSE(changesOnlyNumbers({"shape.a.box.size=1"}, {}));
}

}  // namespace
}  // namespace vitrine
