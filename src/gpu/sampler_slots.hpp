// SPDX-License-Identifier: MIT
#pragma once

namespace vitrine {

/// Once a context, for Mesa's software drivers. They compile a program once more whenever the
/// samplers that it finds are of another kind, and for a texel buffer, which has none, they find
/// the one that some program before has left in its place: all programs would be compiled twice,
/// for the first sample and for the second. This leaves the samplers of our images in every place.
void fillSamplerSlots();

}  // namespace vitrine
