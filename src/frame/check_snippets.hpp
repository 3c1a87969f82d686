// SPDX-License-Identifier: MIT
// Compiles each snippet by itself, so that one run reports the mistakes in all of them.
#pragma once

#include "gpu/context.hpp"
#include "pack/assets.hpp"

namespace vitrine {

/// The driver's complaints about the scene's snippets, each at its place in the user's file.
Diagnostics checkSnippets(const Context& context, const Assets& assets);

}  // namespace vitrine
