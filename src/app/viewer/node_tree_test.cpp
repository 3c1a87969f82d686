// SPDX-License-Identifier: MIT
#include "app/viewer/node_tree.hpp"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

Scene scene() {
    Scene result;
    const auto add = [&](const char* name, const char* parent) {
        Node node;
        node.name = name;
        node.parent.name = parent;
        result.nodes.push_back(node);
    };
    add("wheel", "car");  // before its parent
    add("car", "");
    add("", "car");
    add("", "");
    add("car/hub", "wheel");
    add("tree", "");
    return result;
}

TEST(NodeTree, KnowsWhatHangsOnWhat) {
    const Scene s = scene();
    const NodeTree tree(s);
    EXPECT_EQ(tree.roots(), (std::vector<size_t>{1, 3, 5}));
    EXPECT_EQ(tree.children(1), (std::vector<size_t>{0, 2}));
    EXPECT_EQ(tree.children(0), (std::vector<size_t>{4}));
    EXPECT_TRUE(tree.children(3).empty()) << "nothing hangs on what has no name";
    EXPECT_EQ(tree.parent(4), 0u);
    EXPECT_FALSE(tree.parent(5));
    EXPECT_TRUE(tree.isWithin(4, 1));
    EXPECT_TRUE(tree.isWithin(1, 1));
    EXPECT_FALSE(tree.isWithin(1, 4));
    EXPECT_FALSE(tree.isWithin(4, 5));
    EXPECT_EQ(shortName(s, tree, 4), "hub");
    EXPECT_EQ(shortName(s, tree, 0), "wheel");
}

}  // namespace
}  // namespace vitrine
