// SPDX-License-Identifier: MIT
#include "app/viewer/film_plan.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "app/viewer/recorder.hpp"

namespace vitrine {
namespace {

TEST(FilmPlan, ShowsTheFramesThatRenderDraws) {
    FilmPlan plan;
    plan.from = 1;
    plan.seconds = 2;
    for (const int rate : {24, 25, 30, 60}) {
        plan.framesPerSecond = rate;
        ASSERT_EQ(plan.frames(), 2 * rate);
        EXPECT_EQ(plan.firstFrame(), rate);
        for (int i = 0; i < plan.frames(); ++i) {
            const float fps = static_cast<float>(rate);  // as the command line reads --fps
            ASSERT_EQ(plan.timeOf(i), static_cast<float>(rate + i) / fps);
        }
    }
}

TEST(FilmPlan, EndsBeforeALoopBeginsAnew) {
    FilmPlan plan;
    plan.seconds = 8;
    EXPECT_LT(plan.timeOf(plan.frames() - 1), 8);
    EXPECT_EQ(plan.timeOf(plan.frames()), 8);
    plan.seconds = 0;
    EXPECT_EQ(plan.frames(), 1);
}

TEST(FilmPlan, TurnsTheCameraAroundItsTargetWhileTimeStands) {
    Camera camera;
    camera.eye = {3, 2, 1};
    camera.target = {1, 0.5f, 0};
    camera.up = glm::normalize(glm::vec3(0.1f, 1, 0));
    FilmPlan plan;
    plan.what = FilmPlan::What::kTurn;
    plan.from = 0.7f;
    plan.seconds = 4;
    plan.framesPerSecond = 25;
    const float distance = glm::distance(camera.eye, camera.target);
    const float step = glm::distance(plan.cameraOf(0, camera).eye, plan.cameraOf(1, camera).eye);
    for (int i = 0; i < plan.frames(); ++i) {
        const Camera at = plan.cameraOf(i, camera), next = plan.cameraOf(i + 1, camera);
        EXPECT_EQ(plan.timeOf(i), 0.7f);
        EXPECT_EQ(at.target, camera.target);
        EXPECT_NEAR(at.eye.y, camera.eye.y, 1e-5f);
        EXPECT_NEAR(glm::distance(at.eye, at.target), distance, 1e-5f);
        // Equal steps, also from the last frame to the first one.
        EXPECT_NEAR(glm::distance(at.eye, next.eye), step, 1e-5f);
        EXPECT_NEAR(glm::dot(at.up, at.eye - at.target),
                    glm::dot(camera.up, camera.eye - camera.target), 1e-5f);
    }
    EXPECT_EQ(plan.cameraOf(0, camera).eye, camera.eye);
    const Camera half = plan.cameraOf(50, camera);
    EXPECT_NEAR(half.eye.x, -1, 1e-5f);
    EXPECT_NEAR(half.eye.z, -1, 1e-5f);
}

TEST(Recorder, WritesDownHowLongItTakes) {
    EXPECT_EQ(clockText(0), "0:00");
    EXPECT_EQ(clockText(34.2), "0:35");
    EXPECT_EQ(clockText(3725), "1:02:05");
    EXPECT_EQ(clockText(-1), "0:00");
    EXPECT_EQ(clockText(1e30), "1000:00:00");
}

}  // namespace
}  // namespace vitrine
