// SPDX-License-Identifier: MIT
#include "pack/tree_level.hpp"

#include <gtest/gtest.h>

namespace vitrine {
namespace {
TEST(TreeLevel, Placeholder) {}
}  // namespace
}  // namespace vitrine
