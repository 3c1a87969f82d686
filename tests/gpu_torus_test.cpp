// SPDX-License-Identifier: MIT
// scenes/torus-compare.toml: the torus as a mesh and as a field in the same place. With a fine mesh
// nobody can tell them apart, in depth or in what they mirror; with the coarse one that the scene
// shows, anybody can.
#include <map>

#include "gpu_support.hpp"
#include "image/compare.hpp"

namespace vitrine {
namespace {

/// Of 0..1: two renderings of the same torus beside each other.
struct Likeness {
    int both = 0, one = 0;    // pixels that show the torus in both pictures, in one
    double worstDepth = 0;    // largest relative difference of depth, where the ray meets the
                              // field at more than 20 degrees
    double psnr = 0;          // of the mirror images, where both show it, dB
    double fractionOver = 0;  // of those pixels, more than 8 of 255 off
};

class TorusTest : public test::GpuTest {
  protected:
    /// `shown` alone, in the middle.
    static LayerImages draw(const std::string& shown, int segments, Camera& camera) {
        std::vector<std::string> overrides{"node." + shown + ".at=[0,0.9,0]",
                                           "node." + shown + ".rotate=[68,20,0]",
                                           "camera.row.eye=[0,1.3,4.6]",
                                           "material.tunnel.set.bars=8",
                                           fmt::format("shape.mesh.torus.segments={}", segments),
                                           fmt::format("shape.mesh.torus.sides={}", segments / 2)};
        for (const char* name : {"mesh", "field", "cut-mesh", "cut-field", "blade"})
            if (shown != name) overrides.push_back(fmt::format("node.{}.visible=false", name));
        Diagnostics diagnostics;
        const LoadedScene loaded = loadAll("scenes/torus-compare.toml", overrides, diagnostics);
        diagnostics.throwIfErrors();
        PictureRequest request;
        request.width = 320;
        request.height = 200;
        request.samples = 1;
        camera = findCamera(loaded.scene, "");
        Renderer renderer(loaded, Backend::kFragment, false);
        return renderer.drawLayers(request, nullptr);
    }

    static Likeness compare(const Camera& camera, const LayerImages& mesh,
                            const LayerImages& field) {
        // The torus stands before everything else in both.
        const uint32_t material = field.ids.at(160, 40)[2];
        Likeness result;
        std::vector<float> a, b;
        for (int y = 0; y < 200; ++y)
            for (int x = 0; x < 320; ++x) {
                const bool inMesh = mesh.ids.at(x, y)[2] == material;
                const bool inField = field.ids.at(x, y)[2] == material;
                result.both += inMesh && inField ? 1 : 0;
                result.one += inMesh != inField ? 1 : 0;
                if (!inMesh || !inField) continue;
                a.insert(a.end(), mesh.light.at(x, y).begin(), mesh.light.at(x, y).end());
                b.insert(b.end(), field.light.at(x, y).begin(), field.light.at(x, y).end());
                const auto normal = field.normal.at(x, y);
                const Ray ray = test::pixelRay(camera, 320, 200, x, y);
                if (-glm::dot(glm::vec3(normal[0], normal[1], normal[2]), ray.direction) < 0.34f)
                    continue;
                result.worstDepth = std::max<double>(
                    result.worstDepth,
                    std::abs(mesh.depth.at(x, y)[0] / field.depth.at(x, y)[0] - 1));
            }
        const int count = result.both;
        const Comparison seen = compareImages(srgbFromLinear({count, 1, std::move(a)}),
                                              srgbFromLinear({count, 1, std::move(b)}), 8);
        result.psnr = seen.psnr;
        result.fractionOver = seen.fractionOver;
        return result;
    }
};

TEST_F(TorusTest, AFineMeshIsTheField) {
    Camera camera;
    const LayerImages field = draw("field", 24, camera);
    std::map<int, Likeness> found;
    for (const int segments : {24, 96, 384}) {
        const Likeness likeness = found[segments] =
            compare(camera, draw("mesh", segments, camera), field);
        fmt::print(
            "{} x {} quads: {} pixels in both, {} in one; depth within {:.4f} %; mirror image "
            "{:.1f} dB, {:.2f} % of pixels more than 8 of 255 off\n",
            segments, segments / 2, likeness.both, likeness.one, 100 * likeness.worstDepth,
            likeness.psnr, 100 * likeness.fractionOver);
        EXPECT_GT(likeness.both, 10000);
    }
    const Likeness &fine = found[384], &coarse = found[24];
    EXPECT_LT(fine.one, 60);
    EXPECT_LT(fine.worstDepth, 0.002);
    EXPECT_GT(fine.psnr, 24);
    EXPECT_LT(fine.fractionOver, 0.07);
    // Nothing of this is true of the coarse mesh.
    EXPECT_GT(coarse.one, 250);
    EXPECT_GT(coarse.worstDepth, 0.002);
    EXPECT_LT(coarse.psnr, 17);
    EXPECT_GT(coarse.fractionOver, 0.2);
}

}  // namespace
}  // namespace vitrine
