// SPDX-License-Identifier: MIT
// Light whose amount is known on paper.
//
// Tolerance of single pixels: 1.6 steps of 255: one of the dither, a half of the rounding to 8
// bits. Shadows: a pixel counts where its whole neighbourhood, one pixel around it, is on the same
// side of the outline on paper; of those not one may be wrong.
#include "gpu_support.hpp"
#include "mesh/primitives.hpp"

namespace vitrine {
namespace {

constexpr int kWidth = 240, kHeight = 150;
constexpr double kStep = 1.6;

constexpr const char* kSlabField =
    "// bounds[-6, -0.6, -6, 6, 0.1, 6]\n"
    "float sdf(vec3 p) { vec3 q = abs(p + vec3(0.0, 0.25, 0.0)) - vec3(5.0, 0.25, 5.0);\n"
    "return length(max(q, 0.0)) + min(max(q.x, max(q.y, q.z)), 0.0); }";
constexpr const char* kBallField =
    "// bounds[-1.05, -1.05, -1.05, 1.05, 1.05, 1.05]\n"
    "float sdf(vec3 p) { return length(p) - 1.0; }";

double srgbFromLinear(double c) {
    c = std::clamp(c, 0.0, 1.0);
    return 255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055);
}

class LightTest : public test::GpuTest {
  protected:
    static ImageRgba8 draw(const test::TestScene& scene, Backend backend, View view = View::kDirect,
                           int samples = 1) {
        PictureRequest request;
        request.width = kWidth;
        request.height = kHeight;
        request.view = view;
        request.samples = samples;
        return test::drawPicture(scene.load(), backend, request);
    }

    static Camera lookDown() {
        Camera camera;
        camera.eye = {1, 6, 4};
        camera.target = {0, 0, 0};
        camera.fov = 40;
        return camera;
    }
};

/// The mirror lobe of the metallic-roughness model as the glTF 2.0 specification, appendix B,
/// writes it, times the cosine; x is what f0 multiplies, y what f90 does.
glm::dvec2 mirrored(double roughness, const glm::dvec3& n, const glm::dvec3& v,
                    const glm::dvec3& l) {
    const glm::dvec3 h = glm::normalize(v + l);
    const double a2 = std::pow(roughness, 4);
    const double nh = glm::dot(n, h), nl = glm::dot(n, l), nv = glm::dot(n, v), vh = glm::dot(v, h);
    if (nl <= 0) return {0, 0};
    const double d = a2 / (kPi * std::pow(nh * nh * (a2 - 1) + 1, 2));
    const double visibility =
        1 / (nl + std::sqrt(a2 + (1 - a2) * nl * nl)) / (nv + std::sqrt(a2 + (1 - a2) * nv * nv));
    // The product form of the specification is Smith without height correlation; the shaders use
    // the correlated form, which the specification allows ("may use").
    const double correlated =
        0.5 / (nl * std::sqrt(a2 + (1 - a2) * nv * nv) + nv * std::sqrt(a2 + (1 - a2) * nl * nl));
    EXPECT_LE(visibility, correlated * 1.0001);
    const double power = std::pow(1 - vh, 5);
    return d * correlated * nl * glm::dvec2(1 - power, power);
}

/// What it sends back in all directions, by integrating over the hemisphere.
glm::dvec2 mirroredInAll(double roughness, double nv) {
    const glm::dvec3 n(0, 0, 1), v(std::sqrt(1 - nv * nv), 0, nv);
    constexpr int kPolar = 200, kAround = 200;
    glm::dvec2 sum(0);
    for (int i = 0; i < kPolar; ++i)
        for (int j = 0; j < kAround; ++j) {
            const double polar = 0.5 * kPi * (i + 0.5) / kPolar, around = kPi * (j + 0.5) / kAround;
            const glm::dvec3 l(std::sin(polar) * std::cos(around),
                               std::sin(polar) * std::sin(around), std::cos(polar));
            sum += mirrored(roughness, n, v, l) * std::sin(polar);
        }
    return sum * (kPi * double{kPi} / kPolar / kAround);
}

/// Light from l, times the cosine, of what is not metal: light that bounces between microfacets is
/// added in proportion, and the body has what the mirror leaves. `all`: mirroredInAll().
double reflected(double base, double roughness, const glm::dvec3& n, const glm::dvec3& v,
                 const glm::dvec3& l, const glm::dvec2& all) {
    constexpr double kF0 = 0.04;
    const double whole = all.x + all.y, boost = 1 + kF0 * (1 - whole) / whole;
    const glm::dvec2 lobe = boost * mirrored(roughness, n, v, l);
    const double left = 1 - boost * (kF0 * all.x + all.y);
    return kF0 * lobe.x + lobe.y + left * base / kPi * std::max(glm::dot(n, l), 0.0);
}

TEST_F(LightTest, PlaneUnderASunHasTheRadianceOnPaper) {
    const glm::vec3 sun = glm::normalize(glm::vec3(-0.5f, -1, 0.3f));
    constexpr float kIrradiance = 2;
    std::vector<glm::dvec2> table;
    for (int i = 0; i <= 20; ++i) table.push_back(mirroredInAll(1, std::max(0.05 * i, 0.01)));
    for (const bool field : {false, true})
        for (const float base : {1.0f, 0.4f})
            for (const Backend backend : test::kBackends) {
                SCOPED_TRACE(test::nameOf(backend) + (field ? ", field" : ", mesh"));
                test::TestScene scene;
                Material white;
                white.baseColor.rgb = glm::vec3(base);
                white.roughness = 1;
                const int material = scene.addMaterial(white);
                scene.add(field ? scene.addField(kSlabField) : scene.addMesh(makePlane(5, 5)),
                          material);
                scene.addSun(sun, kIrradiance);
                scene.scene.cameras[0] = lookDown();
                const ImageRgba8 image = draw(scene, backend);
                double worst = 0;
                int count = 0;
                for (int y = 0; y < kHeight; ++y)
                    for (int x = 0; x < kWidth; ++x) {
                        const Ray ray = test::pixelRay(lookDown(), kWidth, kHeight, x, y);
                        const glm::vec3 p =
                            ray.origin - ray.origin.y / ray.direction.y * ray.direction;
                        if (std::max(std::abs(p.x), std::abs(p.z)) > 4.9f) continue;
                        ++count;
                        const double cosine = -ray.direction.y;
                        const auto node = static_cast<size_t>(20 * cosine);
                        const glm::dvec2 all =
                            glm::mix(table[node], table[node + 1], 20 * cosine - double(node));
                        const double radiance =
                            kIrradiance * reflected(base, 1, {0, 1, 0}, -glm::dvec3(ray.direction),
                                                    -glm::dvec3(sun), all);
                        const double expected = srgbFromLinear(radiance);
                        for (int c = 0; c < 3; ++c)
                            worst = std::max(worst, std::abs(image.at(x, y)[c] - expected));
                    }
                EXPECT_LT(worst, kStep);
                EXPECT_GT(count, kWidth * kHeight / 2);
            }
}

/// Is the point of the plane y = 0 that a pixel shows in the shadow of the unit sphere at `centre`?
/// Nothing where the pixel does not show the plane.
std::optional<bool> inShadow(const Camera& camera, int x, int y, const glm::dvec3& centre,
                             const glm::dvec3& toSun) {
    const Ray here = test::pixelRay(camera, kWidth, kHeight, x, y);
    const glm::dvec3 o(here.origin), d(here.direction);
    const auto meets = [&centre](const glm::dvec3& from, const glm::dvec3& way) {
        const glm::dvec3 to = centre - from;
        const double along = glm::dot(to, way);
        return along > 0 && glm::dot(to, to) - along * along < 1;
    };
    if (d.y >= 0 || meets(o, d)) return {};
    const glm::dvec3 p = o - o.y / d.y * d;
    if (std::max(std::abs(p.x), std::abs(p.z)) > 4.9) return {};
    return meets(p, toSun);
}

void expectShadow(test::TestScene& scene, const ImageRgba8& image, const glm::vec3& centre,
                  const glm::vec3& sun) {
    int lit = 0, dark = 0, wrong = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            int shadows = 0, known = 0;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    if (const auto shadow = inShadow(scene.scene.cameras[0], x + dx, y + dy, centre,
                                                     -glm::dvec3(sun))) {
                        ++known;
                        shadows += *shadow;
                    }
            if (known < 9 || (shadows != 0 && shadows != 9)) continue;
            const bool isDark = image.at(x, y)[0] < 20;
            ++(shadows ? dark : lit);
            if (isDark != (shadows == 9) && ++wrong <= 3)
                ADD_FAILURE() << "pixel " << x << ", " << y << " is " << int(image.at(x, y)[0]);
        }
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(dark, 500);
    EXPECT_GT(lit, 5000);
}

TEST_F(LightTest, ShadowsEndWhereTheyMust) {
    const glm::vec3 sun = glm::normalize(glm::vec3(-0.6f, -1, 0.2f)), centre(0.8f, 1.5f, -0.4f);
    for (const bool fieldBall : {false, true})
        for (const bool fieldFloor : {false, true})
            for (const Backend backend : test::kBackends) {
                SCOPED_TRACE(test::nameOf(backend) + (fieldBall ? ", ball is a field" : "") +
                             (fieldFloor ? ", floor is a field" : ""));
                test::TestScene scene;
                scene.add(fieldFloor ? scene.addField(kSlabField) : scene.addMesh(makePlane(5, 5)));
                scene
                    .add(fieldBall ? scene.addField(kBallField) : scene.addMesh(makeSphere(1, 128)))
                    .at = centre;
                scene.addSun(sun, 3);
                scene.scene.cameras[0] = lookDown();
                expectShadow(scene, draw(scene, backend), centre, sun);
            }
}

TEST_F(LightTest, LitSidesOfBallsHaveNoAcne) {
    // `shadow` is white where the sun is seen: everywhere on its side of a ball, even where it
    // grazes.
    for (const bool field : {false, true})
        for (const glm::vec3& scale : {glm::vec3(1), glm::vec3(1, 0.15f, 1)})
            for (const glm::vec3& sun :
                 {glm::vec3(-1, -1, 0), glm::vec3(0, -1, 0.01f), glm::vec3(1, 0.01f, -0.2f)}) {
                SCOPED_TRACE(field ? "field" : "mesh");
                test::TestScene scene;
                scene.add(field ? scene.addField(kBallField) : scene.addMesh(makeSphere(1))).scale =
                    scale;
                scene.addSun(sun, 1);
                Camera& camera = scene.scene.cameras[0];
                camera.eye = {2, 1.5f, 4};
                camera.target = {0, 0, 0};
                const ImageRgba8 image = draw(scene, Backend::kAuto, View::kShadow);
                int dark = 0, lit = 0;
                for (int y = 0; y < kHeight; ++y)
                    for (int x = 0; x < kWidth; ++x) {
                        const Ray ray = test::pixelRay(camera, kWidth, kHeight, x, y);
                        const glm::dvec3 s(scale);
                        const glm::dvec3 o = glm::dvec3(ray.origin) / s;
                        const glm::dvec3 d = glm::dvec3(ray.direction) / s;
                        const double dd = glm::dot(d, d), od = glm::dot(o, d);
                        const double root = od * od - dd * (glm::dot(o, o) - 1);
                        if (root < 0.01) continue;
                        const glm::dvec3 hit = o + (-od - std::sqrt(root)) / dd * d;
                        const glm::dvec3 n = glm::normalize(hit / s);
                        const double cosine = -glm::dot(n, glm::normalize(glm::dvec3(sun)));
                        // A triangle is up to 2.7 degrees off the sphere, and more when squeezed; a
                        // field's normal is taken over a fifth of a pixel.
                        if (cosine < (field ? 0.01 : 0.05 / scale.y)) continue;
                        ++lit;
                        dark += image.at(x, y)[0] < 250;
                    }
                EXPECT_EQ(dark, 0) << "of " << lit;
                EXPECT_GT(lit, 40);
            }
}

/// Means of rings of a ball in the middle of the picture, by the cosine between normal and viewer.
struct Ring {
    double least, most, sum = 0;
    int count = 0;
    [[nodiscard]] double mean() const { return sum / count; }
};

std::array<Ring, 3> ringsOf(const ImageRgba8& image, const Camera& camera) {
    std::array<Ring, 3> rings{Ring{0.9, 1}, Ring{0.7, 0.8}, Ring{0.4, 0.5}};
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const Ray ray = test::pixelRay(camera, kWidth, kHeight, x, y);
            const glm::dvec3 o(ray.origin), d(ray.direction);
            const double od = glm::dot(o, d), root = od * od - glm::dot(o, o) + 1;
            if (root <= 0) continue;
            const double cosine = std::sqrt(root);
            for (Ring& ring : rings) {
                if (cosine < ring.least || cosine > ring.most) continue;
                ring.sum += test::linearFromSrgb(image.at(x, y)[0]);
                ++ring.count;
            }
        }
    return rings;
}

std::vector<Material> whiteMaterials() {
    std::vector<Material> materials;
    for (const float metallic : {0.0f, 0.5f, 1.0f})
        for (const float roughness : {0.0f, 0.3f, 0.6f, 1.0f})
            for (const float coat : {0.0f, 1.0f})
                for (const float sheen : {0.0f, 1.0f}) {
                    Material m;
                    m.baseColor.rgb = glm::vec3(1);
                    m.metallic = metallic;
                    m.roughness = roughness;
                    m.clearcoat = coat;
                    m.clearcoatRoughness = 0.3f;
                    m.sheenColor.rgb = glm::vec3(sheen);
                    m.sheenRoughness = 0.6f;
                    materials.push_back(m);
                }
    return materials;
}

/// A white ball in white surroundings cannot be told from them, whatever it is made of: within
/// 1.5 %, of which the noise of some 10,000 samples is 0.3 % and the table of albedos the rest.
TEST_F(LightTest, WhiteFurnace) {
    constexpr double kRadiance = 0.5;
    int number = 0;
    for (const Material& m : whiteMaterials())
        for (const RenderMode mode : {RenderMode::kHybrid, RenderMode::kReference}) {
            // Either shape in its turn: what answers light does not know which it is.
            const bool field = ++number % 3 == 0;
            SCOPED_TRACE(fmt::format("metallic {}, roughness {}, coat {}, sheen {}, {}, {}",
                                     m.metallic, m.roughness, m.clearcoat, m.sheenColor.rgb.x,
                                     field ? "field" : "mesh",
                                     mode == RenderMode::kHybrid ? "hybrid" : "reference"));
            test::TestScene scene;
            scene.add(field ? scene.addField(kBallField) : scene.addMesh(makeSphere(1, 96)),
                      scene.addMaterial(m));
            scene.setEnvironment(kRadiance);
            scene.scene.render.bounces = 1;
            scene.scene.render.threshold = 0;
            Camera& camera = scene.scene.cameras[0];
            camera.eye = {0, 0, 4};
            camera.target = {0, 0, 0};
            PictureRequest request;
            request.width = kWidth;
            request.height = kHeight;
            request.samples = 12;
            request.mode = mode;
            const ImageRgba8 image = test::drawPicture(scene.load(), Backend::kAuto, request);
            for (const Ring& ring : ringsOf(image, camera)) {
                EXPECT_GT(ring.count, 300);
                EXPECT_NEAR(ring.mean() / kRadiance, 1, 0.015) << "cosine " << ring.least;
            }
        }
}

}  // namespace
}  // namespace vitrine
