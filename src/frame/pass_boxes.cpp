// SPDX-License-Identifier: MIT
#include "frame/passes.hpp"

namespace vitrine {

void boxesPass(PassContext& context, const TreeBoxes& boxes, const Texture& records,
               Texture& picture) {
    // A triangle that covers the picture, then twelve edges of two triangles a box, twice: what is
    // behind a surface, and over it what is in front.
    constexpr int kVerticesOfBox = 12 * 6;
    context.block.sampling.z = 0;
    context.block.sampling.x = boxes.count();
    context.block.sampling.y = boxes.firstTriangleTexel();
    context.overlay("boxes",
                    {{{"records", &records}},
                     {{"boxCorners", &boxes.corners()}, {"boxNumbers", &boxes.numbers()}},
                     {{"outColor", &picture}}},
                    3 + 2 * kVerticesOfBox * boxes.count());
}

}  // namespace vitrine
