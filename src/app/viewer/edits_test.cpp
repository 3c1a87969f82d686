// SPDX-License-Identifier: MIT
#include "app/viewer/edits.hpp"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

using List = std::vector<std::string>;

TEST(Edits, AreUndoneAndRedoneStepByStep) {
    Edits edits;
    EXPECT_FALSE(edits.undo());
    edits.set("a.b", "1");
    edits.set("a.c", "2");
    edits.set("a.b", "3");
    EXPECT_EQ(edits.assignments(), (List{"a.b=3", "a.c=2"}));
    EXPECT_TRUE(edits.undo());
    EXPECT_EQ(edits.assignments(), (List{"a.b=1", "a.c=2"}));
    EXPECT_TRUE(edits.undo());
    EXPECT_TRUE(edits.undo());
    EXPECT_TRUE(edits.empty());
    EXPECT_FALSE(edits.undo());
    EXPECT_TRUE(edits.redo());
    EXPECT_TRUE(edits.redo());
    EXPECT_TRUE(edits.redo());
    EXPECT_FALSE(edits.redo());
    EXPECT_EQ(edits.assignments(), (List{"a.b=3", "a.c=2"}));
}

TEST(Edits, OneDragIsOneStep) {
    Edits edits;
    for (int i = 0; i < 50; ++i) edits.set("a.b", std::to_string(i), 7);
    for (int i = 0; i < 50; ++i) edits.set("a.b", std::to_string(i), 8);
    EXPECT_TRUE(edits.undo());
    EXPECT_EQ(edits.assignments(), List{"a.b=49"});
    EXPECT_TRUE(edits.undo());
    EXPECT_TRUE(edits.empty());
}

TEST(Edits, AChangeAfterUndoForgetsTheFuture) {
    Edits edits;
    edits.set("a", "1");
    edits.set("a", "2");
    edits.undo();
    edits.set("a", "3");
    EXPECT_FALSE(edits.redo());
    edits.undo();
    EXPECT_EQ(edits.assignments(), List{"a=1"});
}

TEST(Edits, TheSameValueIsNoStep) {
    Edits edits;
    edits.set("a", "1");
    const int version = edits.version();
    edits.set("a", "1");
    edits.reset("b");
    EXPECT_EQ(edits.version(), version);
    edits.reset("a");
    EXPECT_TRUE(edits.empty());
    edits.undo();
    EXPECT_EQ(edits.assignments(), List{"a=1"});
}

}  // namespace
}  // namespace vitrine
