// SPDX-License-Identifier: MIT
// The `march` finder, which draws the boxes of fields, against the `trace` finder and, where there
// is one, a formula.
//
// Records: fewer than 0.1 % of the pixels may name another surface; they are pixels where the
// rasteriser's 1/256 of a pixel, or its depth, decides between a mesh and what is behind or beside
// it. Where both name the same field, they are the same to the bit: both march in the same way.
// Pictures: fewer than 0.1 % of the pixels off by more than 5 of 255.
#include "frame/first_hits.hpp"
#include "gpu_support.hpp"
#include "image/compare.hpp"
#include "mesh/primitives.hpp"
#include "pack/camera.hpp"

namespace vitrine {
namespace {

constexpr int kWidth = 160, kHeight = 100;
constexpr double kMostPixels = 0.001;

const std::string kBall =
    "// bounds[-0.5, -0.5, -0.5, 0.5, 0.5, 0.5]\n"
    "float sdf(vec3 p) { return length(p) - 0.45; }\n";
const std::string kTorus =
    "// bounds[-0.7, -0.2, -0.7, 0.7, 0.2, 0.7]\n"
    "vec2 sdf(vec3 p) {\n"
    "    vec2 q = vec2(length(p.xz) - 0.5, p.y);\n"
    "    return vec2(length(q) - 0.15, p.x > 0.0 ? 1.0 : 0.0);\n"
    "}\n";

class MarchTest : public test::GpuTest {};

/// The records of a camera's rays, by either finder.
class Finders {
  public:
    Finders(const Context& gpu, const LoadedScene& loaded, bool counters = false,
            const glm::vec2& jitter = glm::vec2(0))
        : context_(gpu.info(),
                   ProgramSet(gpu.info(), Backend::kFragment, loaded.packed.shaders,
                              featuresOf(loaded.packed, counters)),
                   counters),
          packed_(loaded.packed),
          depth_(kWidth, kHeight) {
        context_.scene.upload(packed_);
        context_.block = packed_.block;
        packCamera(loaded.scene.cameras[0], kWidth, kHeight, context_.block);
        context_.block.jitter = glm::vec4(jitter, 1, 0);
        context_.block.sampling.y = 1;
        records_ = Texture(kWidth, kHeight, TexelFormat::kRgba32ui);
        spare_ = Texture(kWidth, kHeight, TexelFormat::kRgba32ui);
        for (Texture& t : context_.counters) {
            t = Texture(kWidth, kHeight, TexelFormat::kRgba32ui);
            t.clear();
        }
    }
    std::vector<glm::uvec4> raster(FieldFinder finder = FieldFinder::kBoxes) {
        rasterFirstHits(context_, packed_.instances, packed_.fieldRoot, finder, depth_, spare_,
                        records_);
        return read();
    }
    std::vector<glm::uvec4> trace() {
        visibilityPass(context_, records_);
        return read();
    }
    /// Of the last search: evaluations of fields.
    [[nodiscard]] uint64_t evaluations() const {
        uint64_t sum = 0;
        const std::vector<uint32_t> texels = context_.counters[0].readUints();
        for (size_t i = 2; i < texels.size(); i += 4) sum += texels[i];
        return sum;
    }
    [[nodiscard]] FieldBoxes boxes() const { return fieldBoxes(context_.block, packed_.instances); }
    void forgetCounts() { context_.counters[0].clear(); }

  private:
    std::vector<glm::uvec4> read() {
        const std::vector<uint32_t> texels = records_.readUints();
        std::vector<glm::uvec4> records(texels.size() / 4);
        for (size_t i = 0; i < records.size(); ++i)
            records[i] = {texels[4 * i], texels[4 * i + 1], texels[4 * i + 2], texels[4 * i + 3]};
        return records;
    }

    PassContext context_;
    PackedScene packed_;
    DepthImage depth_;
    Texture records_, spare_;
};

/// `least`: pixels that must show a field, for the test to say something.
void expectSameRecords(const Context& gpu, const LoadedScene& loaded, int least,
                       const glm::vec2& jitter = glm::vec2(0)) {
    Finders finders(gpu, loaded, false, jitter);
    const std::vector<glm::uvec4> traced = finders.trace();
    for (const FieldFinder finder : {FieldFinder::kBoxes, FieldFinder::kTree}) {
        SCOPED_TRACE(finder == FieldFinder::kBoxes ? "boxes" : "tree");
        const std::vector<glm::uvec4> found = finders.raster(finder);
        int others = 0, fields = 0, unlike = 0;
        for (size_t i = 0; i < found.size(); ++i) {
            const glm::uvec4 a = found[i], b = traced[i];
            if (!record::isSurface(a) && !record::isSurface(b)) continue;
            const bool field = record::isSurface(a) && loaded.packed.instances[a.x].field;
            if (a.x != b.x || (!field && a.y != b.y)) {
                ++others;
            } else if (field) {
                ++fields;
                unlike += a != b;
            } else {
                ASSERT_NEAR(record::recordDistance(a), record::recordDistance(b),
                            1e-4 * record::recordDistance(b));
            }
        }
        EXPECT_LT(others, kMostPixels * kWidth * kHeight);
        EXPECT_EQ(unlike, 0) << "of " << fields;
        EXPECT_GE(fields, least);
    }
}

Camera cameraAt(const glm::vec3& eye, const glm::vec3& target, float fov = 50) {
    Camera camera;
    camera.eye = eye;
    camera.target = target;
    camera.fov = fov;
    return camera;
}

void turnAndSqueeze(Node& node) {
    node.rotate = {25, -40, 15};
    node.scale = {-0.5f, 1.8f, 0.9f};
}

}  // namespace

TEST_F(MarchTest, ScenesLookTheSame) {
    for (const char* name : {"robot", "morph", "lesson-march"}) {
        Diagnostics diagnostics;
        const LoadedScene loaded =
            loadAll(fmt::format("scenes/{}.toml", name), {"render.bounces=1"}, diagnostics);
        diagnostics.throwIfErrors();
        PictureRequest request;
        request.width = kWidth;
        request.height = kHeight;
        request.samples = 2;
        request.primary = Primary::kRaster;
        const ImageRgba8 raster = test::drawPicture(loaded, Backend::kFragment, request);
        const ImageRgba8 compute = test::drawPicture(loaded, Backend::kCompute, request);
        request.primary = Primary::kTrace;
        const ImageRgba8 trace = test::drawPicture(loaded, Backend::kFragment, request);
        EXPECT_LT(compareImages(raster, trace).fractionOver, kMostPixels) << name;
        EXPECT_LT(compareImages(compute, trace).fractionOver, kMostPixels) << name;
    }
}

TEST_F(MarchTest, AFieldInAMeshIsCutByIt) {
    test::TestScene made;
    made.add(made.addMesh(makeBox(glm::vec3(0.4f)))).rotate = {20, 30, 0};
    made.add(made.addField(kBall));
    made.add(made.addMesh(makePlane(3, 3))).at = {0, -0.2f, 0};
    made.add(made.addMesh(makeSphere(0.3f))).at = {0.4f, 0.1f, 0.2f};
    made.scene.cameras = {cameraAt({1, 0.8f, 1.6f}, {0, 0, 0}, 40)};
    expectSameRecords(context(), made.load(), 500);
    expectSameRecords(context(), made.load(), 500, {0.37f, -0.29f});
}

TEST_F(MarchTest, FieldsCrossEachOther) {
    test::TestScene made;
    const int ball = made.addField(kBall), torus = made.addField(kTorus);
    made.add(ball);
    made.add(torus).rotate = {70, 20, 0};
    turnAndSqueeze(made.add(torus));
    made.add(ball).at = {0.3f, 0.2f, 0.3f};
    made.scene.cameras = {cameraAt({0.9f, 0.7f, 1.8f}, {0, 0, 0}, 40)};
    expectSameRecords(context(), made.load(), 3000);
}

TEST_F(MarchTest, TheEyeInABoxOrAtItsEdge) {
    struct Case {
        const char* name;
        glm::vec3 eye, target;  // in the torus's space
    };
    const Case cases[] = {{"in the hole", {0, 0.05f, 0}, {0.5f, 0, 0.1f}},
                          {"in a corner", {0.69f, 0.19f, 0.69f}, {0, 0, 0}},
                          {"in the solid", {0.5f, 0, 0}, {0, 0, 0}},
                          {"a hair outside", {0.7003f, 0.1f, 0.2f}, {0, 0, 0}},
                          {"outside, beside it", {0.71f, 0.12f, 0.2f}, {0.6f, 0, -0.9f}},
                          {"outside, above it", {0.2f, 0.3f, 0.1f}, {0.9f, 0.1f, 0.5f}}};
    for (const bool squeezed : {false, true})
        for (const Case& c : cases) {
            SCOPED_TRACE(std::string(c.name) + (squeezed ? ", squeezed and mirrored" : ""));
            test::TestScene made;
            Node& node = made.add(made.addField(kTorus));
            node.at = {0.3f, -0.2f, 0.1f};
            if (squeezed) turnAndSqueeze(node);
            made.add(made.addMesh(makeSphere(0.1f))).at = {0.5f, -0.2f, 0.4f};
            const glm::mat4 world = made.load().packed.instances[0].worldFromObject;
            made.scene.cameras = {cameraAt(glm::vec3(world * glm::vec4(c.eye, 1)),
                                           glm::vec3(world * glm::vec4(c.target, 1)), 70)};
            expectSameRecords(context(), made.load(), 300);
        }
}

// Corners that are out of all proportion to the distance of the nearest place.
TEST_F(MarchTest, AGroundOfTwoHundredKilometres) {
    test::TestScene made;
    made.add(
        made.addField("// bounds[-1e5, -1, -1e5, 1e5, 0, 1e5]\n"
                      "float sdf(vec3 p) { return p.y + 0.2; }\n"));
    made.add(made.addField(kBall));
    made.add(made.addMesh(makeSphere(0.3f))).at = {0.4f, -0.1f, 0.2f};
    for (const float height : {0.003f, 0.4f, 40.0f}) {
        made.scene.cameras = {cameraAt({1, height, 1.6f}, {0, height - 0.1f, 0}, 60)};
        expectSameRecords(context(), made.load(), 3000, {0.1f, 0.2f});
    }
}

// Not against the tracer, which marches by the same text: a ball that is squeezed is an ellipsoid.
TEST_F(MarchTest, SqueezedBallsAreEllipsoids) {
    for (const glm::vec3& scale : {glm::vec3(1, 1, 1), glm::vec3(-0.2f, 1.8f, 0.9f),
                                   glm::vec3(3, 0.1f, 1), glm::vec3(-1, -1, -1)}) {
        test::TestScene made;
        Node& node = made.add(made.addField(kBall));
        node.rotate = {25, -40, 15};
        node.scale = scale;
        made.scene.cameras = {cameraAt({1.2f, 0.9f, 2.2f}, {0, 0, 0}, 45)};
        const LoadedScene loaded = made.load();
        const glm::mat4 inverse = glm::inverse(loaded.packed.instances[0].worldFromObject);
        Finders finders(context(), loaded);
        const std::vector<glm::uvec4> found = finders.raster();
        int hits = 0, edges = 0;
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const Ray ray = test::pixelRay(loaded.scene.cameras[0], kWidth, kHeight, x, y);
                const glm::dvec3 o(inverse * glm::vec4(ray.origin, 1));
                const glm::dvec3 d(inverse * glm::vec4(ray.direction, 0));
                const double a = glm::dot(d, d), b = glm::dot(o, d);
                const double root = b * b - a * (glm::dot(o, o) - 0.45 * 0.45);
                const glm::uvec4 r = found[static_cast<size_t>((kHeight - 1 - y) * kWidth + x)];
                if (record::isSurface(r) != (root > 0)) {
                    ++edges;
                    continue;
                }
                if (root <= 0) continue;
                ++hits;
                // Stopped within a fifth of the pixel's footprint, along the normal.
                const glm::dvec3 p = o + (-b - std::sqrt(root)) / a * d;
                const double slant = -glm::dot(glm::normalize(p), glm::normalize(d));
                if (slant < 0.15) continue;
                const double t = (-b - std::sqrt(root)) / a;
                ASSERT_NEAR(record::recordDistance(r), t, 0.004 / slant) << x << ", " << y;
                ASSERT_LE(record::recordDistance(r), t + 1e-4) << x << ", " << y;
            }
        EXPECT_GT(hits, 100);
        EXPECT_LT(edges, hits / 50 + 20);
    }
}

TEST_F(MarchTest, ManyFields) {
    std::mt19937 random(test::seedOr(811));
    test::TestScene made;
    const int shapes[] = {made.addField(kBall), made.addField(kTorus)};
    for (int i = 0; i < 100; ++i) {
        Node& node = made.add(shapes[i % 2]);
        node.at = {test::uniform(random, -2, 2), test::uniform(random, -1, 1),
                   test::uniform(random, -2, 2)};
        node.rotate = {test::uniform(random, -90, 90), test::uniform(random, -90, 90), 0};
        node.scale = {test::uniform(random, 0.2f, 0.5f), i % 3 == 0 ? -0.3f : 0.3f, 0.4f};
    }
    made.add(made.addMesh(makePlane(4, 4))).at = {0, -0.3f, 0};
    made.scene.cameras = {cameraAt({1.5f, 1.5f, 3.5f}, {0, 0, 0}, 45)};
    expectSameRecords(context(), made.load(), 3000);
}

TEST_F(MarchTest, MoreFieldsThanProgramsOfTheirOwn) {
    test::TestScene made;
    for (int i = 0; i < 11; ++i) {
        const int shape = made.addField(
            fmt::format("// bounds[-0.5, -0.5, -0.5, 0.5, 0.5, 0.5]\n"
                        "uniform float grow; // slider[0, 0, 1]\n"
                        "float sdf(vec3 p) {{ return length(p) - {:.3f} - 0.1 * grow; }}\n",
                        0.2 + 0.015 * i));
        made.add(shape).at = {0.5f * static_cast<float>(i % 4) - 0.75f,
                              0.5f * static_cast<float>(i / 4) - 0.5f, 0};
    }
    made.scene.cameras = {cameraAt({0.2f, 0.3f, 3}, {0, 0, 0}, 45)};
    Finders finders(context(), made.load());
    EXPECT_EQ(finders.boxes().groups.size(), 9u) << "eight alone, and the rest";
    expectSameRecords(context(), made.load(), 2000);
}

// Veils stop a ray by chance, glass never hides what the same ray finds in trace: the records agree
// with those of the tracer, sample by sample, to the bit.
TEST_F(MarchTest, VeilsGlassAndBacks) {
    test::TestScene made;
    Material veil, glass, single;
    veil.alphaMode = AlphaMode::kBlend;
    veil.opacity = 0.5f;
    glass.transmission = 1;
    single.doubleSided = false;
    const int ball = made.addField(kBall), torus = made.addField(kTorus);
    made.add(ball, made.addMaterial(veil));
    made.add(torus).rotate = {70, 20, 0};
    made.add(ball, made.addMaterial(glass)).at = {0.5f, 0.2f, 0.4f};
    turnAndSqueeze(made.add(torus, made.addMaterial(single)));
    made.add(made.addMesh(makeSphere(0.2f)), 0);
    made.scene.cameras = {cameraAt({0.9f, 0.7f, 1.8f}, {0, 0, 0}, 40)};
    expectSameRecords(context(), made.load(), 3000);
    made.scene.cameras = {cameraAt({0.1f, 0.1f, 0.2f}, {0.5f, 0, 0.3f}, 60)};
    expectSameRecords(context(), made.load(), 2000);
}

// Every pixel of a box is marched once: a field alone is evaluated as often as by the tracer.
TEST_F(MarchTest, NoPixelIsMarchedTwice) {
    for (const bool squeezed : {false, true}) {
        test::TestScene made;
        Node& node = made.add(made.addField(kTorus));
        if (squeezed) turnAndSqueeze(node);
        made.scene.cameras = {cameraAt({0.9f, 0.7f, 1.8f}, {0, 0, 0}, 40)};
        Finders finders(context(), made.load(), true);
        (void)finders.raster();
        const uint64_t marched = finders.evaluations();
        finders.forgetCounts();
        (void)finders.trace();
        EXPECT_EQ(marched, finders.evaluations());
        EXPECT_GT(marched, 5000u);
    }
}

// The rear of a box is drawn, mirrored or not: seen from outside, the corners of its front go round
// in the same sense.
TEST_F(MarchTest, BoxesAreOutsideOut) {
    for (const float sign : {1.0f, -1.0f}) {
        test::TestScene made;
        Node& node = made.add(made.addField(kTorus));
        node.rotate = {25, -40, 15};
        node.scale = {sign * 0.5f, 1.8f, 0.9f};
        made.scene.cameras = {cameraAt({0.9f, 0.7f, 1.8f}, {0, 0, 0}, 40)};
        const glm::mat4 m =
            Finders(context(), made.load()).boxes().groups.at(0).boxes.at(0).clipFromBox;
        // The linear map from the box to x, y and depth along the camera's axis.
        const glm::mat3 turned =
            glm::mat3(glm::vec3(m[0].x, m[0].y, m[0].w), glm::vec3(m[1].x, m[1].y, m[1].w),
                      glm::vec3(m[2].x, m[2].y, m[2].w));
        EXPECT_LT(glm::determinant(turned), 0);
    }
}

// Boxes that cover each other are marched in vain; those around the eye are met in any case.
TEST_F(MarchTest, CrowdsOfBoxesAreTraced) {
    struct Case {
        int balls, around;
        bool drawn;
    };
    for (const Case& c : {Case{1, 0, true}, {12, 0, false}, {1, 6, true}}) {
        SCOPED_TRACE(fmt::format("{} balls, {} around the eye", c.balls, c.around));
        test::TestScene made;
        const int ball = made.addField(kBall);
        for (int i = 0; i < c.balls; ++i)
            made.add(ball).at = {0, 0, -0.01f * static_cast<float>(i)};
        for (int i = 0; i < c.around; ++i) {
            Node& node = made.add(ball);
            node.at = {0, 0, -2};
            node.scale = glm::vec3(9.0f + static_cast<float>(i));
        }
        made.scene.cameras = {cameraAt({0.2f, 0.3f, 2}, {0, 0, 0}, 40)};
        Frame frame(context(), made.load().packed, Backend::kFragment, false);
        FrameRequest request;
        request.width = kWidth;
        request.height = kHeight;
        request.camera = made.scene.cameras[0];
        request.timing = true;
        frame.begin(request);
        frame.drawSample();
        const auto seconds = frame.statistics().secondsByPass;
        EXPECT_EQ(seconds.count("march"), c.drawn ? 1u : 0u);
        EXPECT_EQ(seconds.count("visibility_fields"), c.drawn ? 0u : 1u);
    }
}

}  // namespace vitrine
