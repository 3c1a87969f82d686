// SPDX-License-Identifier: MIT
// scenes/morph.toml, a distance field that changes with time among meshes: the film runs evenly,
// the field stays nearly exact, the things shade and hide one another, and mirrors go four deep.
#include "bvh/build.hpp"
#include "frame/pass_probe_field.hpp"
#include "gpu_support.hpp"
#include "image/compare.hpp"
#include "mesh/primitives.hpp"
#include "sdf/field_slope.hpp"

namespace vitrine {
namespace {

constexpr const char* kScene = "scenes/morph.toml";
constexpr int kWidth = 160, kHeight = 90;
constexpr float kRing = 0.40f, kTube = 0.165f;  // of the torus that the thing is at first

LoadedScene load(const std::vector<std::string>& overrides = {}) {
    Diagnostics diagnostics;
    LoadedScene loaded = loadAll(kScene, overrides, diagnostics);
    diagnostics.throwIfErrors();
    return loaded;
}

PictureRequest at(float time) {
    PictureRequest r;
    r.width = kWidth;
    r.height = kHeight;
    r.samples = 1;
    r.time = time;
    return r;
}

class MorphTest : public test::GpuTest {};

}  // namespace

TEST_F(MorphTest, TheFieldIsNearlyExactAtEveryMoment) {
    FieldProber prober(FieldProber::Thoroughness::kAll, &context());
    Diagnostics diagnostics;
    (void)loadAll(kScene, {}, prober, diagnostics);
    ASSERT_EQ(diagnostics.text(), "");
    ASSERT_EQ(prober.fields().size(), 1u);
    const ProbedField& probed = prober.fields().front();
    judgeField(probed.report, *probed.field, diagnostics);
    EXPECT_EQ(diagnostics.text(), "") << "over all its settings";
    EXPECT_LT(probed.report.steepest.value, 1.02f);

    // Not too flat either, which would cost steps: where it is shown, within 0.3 m of the surface.
    FieldProbe probe(context(), probed.field);
    const FieldDomain domain = domainOf(*probed.field, *probed.field->box(), {});
    FieldSamples samples;
    for (uint32_t i = 0; i < 30000; ++i) addSpread(domain, i, 1e-2f, samples);
    int outside = 0, flat = 0;
    for (const FieldValue& value : probe.ask(samples)) {
        if (value.distance < 0 || value.distance > 0.3f) continue;
        ++outside;
        flat += glm::length(value.gradient) < 0.7f ? 1 : 0;
    }
    fmt::print("slope at most {:.3f}; below 0.7 at {:.2f} % of places outside\n",
               probed.report.steepest.value, 100.0 * flat / outside);
    EXPECT_GT(outside, 5000);
    EXPECT_LT(flat, 0.02 * outside);
}

TEST_F(MorphTest, BeginsAsATorus) {
    FieldProber prober(FieldProber::Thoroughness::kAll, &context());
    Diagnostics diagnostics;
    (void)loadAll(kScene, {}, prober, diagnostics);
    ASSERT_EQ(prober.fields().size(), 1u);
    FieldProbe probe(context(), prober.fields().front().field);
    // Upright, its axis along z, on the table.
    FieldSamples samples;
    for (int i = 0; i < 60; ++i)
        for (int j = 0; j < 30; ++j) {
            const float a = 2 * kPi * static_cast<float>(i) / 60;
            const float b = 2 * kPi * static_cast<float>(j) / 30;
            const float r = kRing + kTube * std::cos(b);
            samples.add({{r * std::cos(a), kRing + kTube + r * std::sin(a), kTube * std::sin(b)}},
                        {glm::vec4(0), glm::vec4(0), glm::vec4(4)});
        }
    float worst = 0;
    for (const FieldValue& value : probe.ask(samples))
        worst = std::max(worst, std::abs(value.distance));
    EXPECT_LT(worst, 1e-3f);
}

TEST_F(MorphTest, TheFilmRunsEvenly) {
    // A pop is a step that is much larger than its neighbours; what swims changes where nothing
    // moves, as behind the candle.
    const LoadedScene loaded = load();
    Renderer renderer(loaded, Backend::kFragment, false);
    std::vector<ImageRgba8> frames;
    for (int i = 0; i < 48; ++i)
        frames.push_back(renderer.draw(at(static_cast<float>(i) / 24), {}));
    std::vector<double> steps;
    for (size_t i = 1; i < frames.size(); ++i)
        steps.push_back(compareImages(frames[i - 1], frames[i]).rmse);
    double largest = 0;
    for (size_t i = 1; i + 1 < steps.size(); ++i)
        largest = std::max(largest, steps[i] / std::max(0.5 * (steps[i - 1] + steps[i + 1]), 5e-3));
    fmt::print("from frame to frame: {:.4f} to {:.4f}; at most {:.2f} times its neighbours\n",
               *std::min_element(steps.begin(), steps.end()),
               *std::max_element(steps.begin(), steps.end()), largest);
    EXPECT_LT(largest, 1.6);
    int swimming = 0;
    for (const ImageRgba8& frame : frames)
        for (int y = 0; y < 50; ++y)
            for (int x = 0; x < 30; ++x)
                for (int c = 0; c < 3; ++c)
                    swimming += std::abs(frame.at(x, y)[c] - frames[0].at(x, y)[c]) > 1 ? 1 : 0;
    EXPECT_EQ(swimming, 0);
}

/// The scene at the film's beginning, with a fine mesh of the torus instead of the field.
LoadedScene withMesh() {
    LoadedScene loaded = load();
    Node* thing = nullptr;
    for (Node& node : loaded.scene.nodes)
        if (node.name == "thing") thing = &node;
    for (size_t i = 0; i < loaded.scene.shapes.size(); ++i) {
        if (loaded.scene.shapes[i].name != "thing") continue;
        auto asset = std::make_shared<MeshAsset>();
        Mesh mesh = makeTorus(kRing, kTube, 384, 192);
        asset->bvh = buildTriangleBvh(mesh.positions, mesh.triangles, BuildOptions{});
        asset->mesh = std::make_shared<Mesh>(std::move(mesh));
        loaded.assets.meshes[i] = std::move(asset);
        loaded.assets.fields[i] = nullptr;
        loaded.scene.shapes[i].sdf.name.clear();
    }
    thing->set.clear();
    thing->at = {0, kRing + kTube, 0};
    thing->rotate = {90, thing->rotate.y, 0};
    Diagnostics diagnostics;
    loaded.packed = packScene(loaded.scene, loaded.assets, diagnostics);
    diagnostics.throwIfErrors();
    return loaded;
}

TEST_F(MorphTest, ItsShadowsAndMirrorImagesAreThoseOfAMesh) {
    const ImageRgba8 field = test::drawPicture(load(), Backend::kFragment, at(0));
    const ImageRgba8 mesh = test::drawPicture(withMesh(), Backend::kFragment, at(0));
    const ImageRgba8 none =
        test::drawPicture(load({"node.thing.visible=false"}), Backend::kFragment, at(0));
    const Comparison same = compareImages(field, mesh, 16), other = compareImages(field, none, 16);
    fmt::print("{:.2f} % of pixels differ from the mesh's, {:.1f} % from those without it\n",
               100 * same.fractionOver, 100 * other.fractionOver);
    EXPECT_LT(same.fractionOver, 0.015);
    EXPECT_GT(other.fractionOver, 0.15);
}

TEST_F(MorphTest, FieldAndMeshesHideAndShadeEachOther) {
    // The picture of who is where and the shadows, as it is and without some of its nodes.
    struct Seen {
        LayerImages layers;
        ImageRgba8 shadow;
    };
    const auto look = [](const std::vector<std::string>& hidden) {
        std::vector<std::string> overrides{"light.wall.intensity=0", "light.fill.intensity=0",
                                           "light.key.radius=0"};
        for (const std::string& name : hidden)
            overrides.push_back("node." + name + ".visible=false");
        const LoadedScene loaded = load(overrides);
        Renderer renderer(loaded, Backend::kFragment, false);
        Seen seen{renderer.drawLayers(at(0), {}), {}};
        PictureRequest request = at(0);
        request.view = View::kShadow;
        seen.shadow = renderer.draw(request, {});
        return seen;
    };
    const Scene scene = load().scene;
    uint32_t glaze = 0;
    while (scene.materials.at(glaze).name != "glaze") ++glaze;
    const Seen all = look({}), noThing = look({"thing"});
    const Seen noMeshes = look({"ball", "cube", "ring", "candle"});
    int hides = 0, hidden = 0, shades = 0, shaded = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const bool thing = all.layers.ids.at(x, y)[2] == glaze;
            hides += thing && noThing.layers.ids.at(x, y)[2] != all.layers.ids.at(x, y)[2] ? 1 : 0;
            hidden += !thing && noMeshes.layers.ids.at(x, y)[2] == glaze ? 1 : 0;
            const auto differs = [&](const Seen& other) {
                return std::abs(all.shadow.at(x, y)[1] - other.shadow.at(x, y)[1]) > 60;
            };
            shades += !thing && differs(noThing) ? 1 : 0;
            shaded += thing && differs(noMeshes) ? 1 : 0;
        }
    fmt::print(
        "the field hides {} pixels of meshes and {} of it are hidden by them; it shades {} of "
        "theirs and {} of its own lie in their shadow\n",
        hides, hidden, shades, shaded);
    EXPECT_GT(hides, 1000);
    EXPECT_GT(hidden, 20);
    EXPECT_GT(shades, 100);
    EXPECT_GT(shaded, 20);
}

TEST_F(MorphTest, EachBounceUpToFourIsSeen) {
    // In the mirror: the thing's back, in which is the mirror, in which is the back again.
    const std::vector<std::string> mug{"node.thing.set.moving=0", "node.thing.set.morph=1",
                                       "render.threshold=0"};
    PictureRequest request = at(0);
    request.camera = "mirror";
    const LoadedScene loaded = load(mug);
    uint32_t mirror = 0;
    while (loaded.scene.materials.at(mirror).name != "mirror") ++mirror;
    std::vector<LayerImages> pictures;
    for (int bounces = 1; bounces <= 4; ++bounces) {
        std::vector<std::string> overrides = mug;
        overrides.push_back("render.bounces=" + std::to_string(bounces));
        const LoadedScene deep = load(overrides);
        Renderer renderer(deep, Backend::kFragment, false);
        pictures.push_back(renderer.drawLayers(request, {}));
    }
    for (size_t i = 1; i < pictures.size(); ++i) {
        const ImageRgba8 before = srgbFromLinear(pictures[i - 1].light);
        const ImageRgba8 after = srgbFromLinear(pictures[i].light);
        int changed = 0, elsewhere = 0;
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                int most = 0;
                for (int c = 0; c < 3; ++c)
                    most = std::max(most, std::abs(before.at(x, y)[c] - after.at(x, y)[c]));
                if (most > 8) ++(pictures[i].ids.at(x, y)[2] == mirror ? changed : elsewhere);
            }
        fmt::print("bounce {} changes {} pixels in the mirror, {} elsewhere\n", i + 1, changed,
                   elsewhere);
        EXPECT_GT(changed, 250);
    }
}

}  // namespace vitrine
