// SPDX-License-Identifier: MIT
#include "gpu_support.hpp"

#include "mesh/primitives.hpp"

#include <cstdlib>

#include "pack/camera.hpp"
#include "pack/tree_options.hpp"

namespace vitrine::test {

uint32_t seedOr(uint32_t standard) {
    const char* text = std::getenv("VITRINE_TEST_SEED");
    return text != nullptr ? static_cast<uint32_t>(std::strtoul(text, nullptr, 10)) : standard;
}

std::string nameOf(Backend backend) {
    return backend == Backend::kCompute ? "compute" : "fragment";
}

void GpuTest::SetUp() {
    try {
        context_ = Context::createHeadless();
    } catch (const MachineError& error) {
        if (std::getenv("VITRINE_REQUIRE_GL") != nullptr) FAIL() << error.what();
        GTEST_SKIP() << error.what();
    }
}

TestScene::TestScene() {
    scene.file = "test";
    scene.render.ao = 0;
    scene.render.toneMap = ToneMap::kNone;
    Camera camera;
    camera.fov = 40;
    scene.cameras.push_back(camera);
    setEnvironment(0);
}

int TestScene::addMesh(vitrine::Mesh mesh) {
    auto asset = std::make_shared<MeshAsset>();
    asset->bvh = buildTriangleBvh(mesh.positions, mesh.triangles, buildOptions(scene.bvh));
    asset->mesh = std::make_shared<vitrine::Mesh>(std::move(mesh));
    assets_.meshes.push_back(std::move(asset));
    assets_.fields.push_back(nullptr);
    Shape shape;
    shape.name = "shape" + std::to_string(scene.shapes.size());
    scene.shapes.push_back(shape);
    return static_cast<int>(scene.shapes.size()) - 1;
}

int TestScene::addMesh(const std::vector<glm::vec3>& positions,
                       const std::vector<glm::uvec3>& triangles) {
    vitrine::Mesh mesh;
    mesh.positions = positions;
    mesh.triangles = triangles;
    mesh.normals.assign(positions.size(), glm::vec3(0, 1, 0));
    mesh.uvs.assign(positions.size(), glm::vec2(0));
    mesh.triangleParts.assign(triangles.size(), 0);
    mesh.partNames = {"default"};
    return addMesh(std::move(mesh));
}

int TestScene::addField(const std::string& snippet) {
    Diagnostics diagnostics;
    auto field = parseSnippet(snippet, "test.sdf.glsl", SnippetKind::kField, diagnostics);
    diagnostics.throwIfErrors();
    return addField(std::make_shared<const Snippet>(std::move(*field)));
}

int TestScene::addField(std::shared_ptr<const Snippet> field) {
    assets_.meshes.push_back(nullptr);
    assets_.fields.push_back(std::move(field));
    Shape shape;
    shape.name = "shape" + std::to_string(scene.shapes.size());
    shape.sdf.name = "test.sdf.glsl";
    scene.shapes.push_back(shape);
    return static_cast<int>(scene.shapes.size()) - 1;
}

int TestScene::addMaterial(const Material& material, const std::string& snippet) {
    scene.materials.push_back(material);
    scene.materials.back().name = "material" + std::to_string(scene.materials.size() - 1);
    assets_.materials.push_back(nullptr);
    if (!snippet.empty()) {
        Diagnostics diagnostics;
        auto parsed = parseSnippet(snippet, "test.mat.glsl", SnippetKind::kMaterial, diagnostics);
        diagnostics.throwIfErrors();
        assets_.materials.back() = std::make_shared<Snippet>(std::move(*parsed));
        scene.materials.back().snippet.name = "test.mat.glsl";
    }
    auto& pictures = assets_.pictures.emplace_back();
    for (const MaterialTexture* texture : materialTextures(material))
        pictures.push_back(texture->image);
    return static_cast<int>(scene.materials.size()) - 1;
}

Node& TestScene::add(int shape, int material) {
    Node node;
    node.name = "node" + std::to_string(scene.nodes.size());
    node.shape.name = scene.shapes[static_cast<size_t>(shape)].name;
    if (material >= 0) node.material.name = scene.materials[static_cast<size_t>(material)].name;
    scene.nodes.push_back(node);
    return scene.nodes.back();
}

void TestScene::addSun(const glm::vec3& direction, float intensity) {
    Light light;
    light.direction = direction;
    light.intensity = intensity;
    scene.lights.push_back(light);
}

void TestScene::setEnvironment(float radiance) {
    scene.environment.zenith.rgb = glm::vec3(radiance);
    scene.environment.horizon.rgb = glm::vec3(radiance);
    scene.environment.ground.rgb = glm::vec3(radiance);
}

void TestScene::setSky(const ImageRgba32f& picture) {
    auto sky = std::make_shared<SkyAsset>();
    sky->map = makeSkyMap(picture);
    assets_.sky = std::move(sky);
}

LoadedScene TestScene::load() const {
    LoadedScene loaded;
    loaded.scene = scene;
    loaded.assets = assets_;
    Diagnostics diagnostics;
    loaded.packed = packScene(loaded.scene, loaded.assets, diagnostics);
    diagnostics.throwIfErrors();
    return loaded;
}

LoadedScene mixedScene(bool glass) {
    TestScene made;
    Material mirror, paint, clear;
    mirror.metallic = 1;
    mirror.roughness = 0.05f;
    paint.baseColor.rgb = {0.7f, 0.3f, 0.2f};
    clear.transmission = 1;
    clear.roughness = 0;
    const int ball = made.addField(
        "// bounds[-1, -1, -1,  1, 1, 1]\nfloat sdf(vec3 p) { return length(p) - 0.9; }\n");
    made.add(made.addMesh(makePlane(8, 8)), made.addMaterial(paint)).at = {0, -0.8f, 0};
    made.add(made.addMesh(makeTorus(0.6f, 0.25f, 24, 12)), made.addMaterial(mirror)).at = {1, 0, 0};
    made.add(ball, made.addMaterial(glass ? clear : mirror)).at = {-0.7f, 0.2f, 0.4f};
    made.addSun({-0.4f, -1, -0.5f}, 2);
    made.setEnvironment(0.4f);
    made.scene.cameras[0].eye = {0.5f, 1.5f, 4};
    return made.load();
}

std::vector<glm::vec3> randomDirections(std::mt19937& random, int count) {
    std::vector<glm::vec3> directions;
    for (int i = 0; i < count; ++i) {
        const float z = uniform(random, -1, 1);
        const float angle = uniform(random, 0, 2 * kPi);
        const float r = std::sqrt(1 - z * z);
        directions.push_back(
            glm::normalize(glm::vec3(r * std::cos(angle), r * std::sin(angle), z)));
    }
    return directions;
}

float uniform(std::mt19937& random, float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
}

std::array<glm::vec3, 2> frameOf(const glm::vec3& n) {
    const glm::vec3 other = std::abs(n.x) < 0.6f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    const glm::vec3 a = glm::normalize(glm::cross(n, other));
    return {a, glm::cross(n, a)};
}

ImageRgba8 drawPicture(const LoadedScene& loaded, Backend backend, const PictureRequest& request) {
    Renderer renderer(loaded, backend, showsCounters(request.view));
    return renderer.draw(request, nullptr);
}

double linearFromSrgb(double value) {
    const double c = value / 255;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

Ray pixelRay(const Camera& camera, int width, int height, int x, int y) {
    FrameBlock block{};
    packCamera(camera, width, height, block);
    const glm::vec2 p((2 * (static_cast<float>(x) + 0.5f)) / static_cast<float>(width) - 1,
                      1 - (2 * (static_cast<float>(y) + 0.5f)) / static_cast<float>(height));
    const auto xyz = [](const glm::vec4& v) { return glm::vec3(v.x, v.y, v.z); };
    return {camera.eye, glm::normalize(xyz(block.cameraForward) + p.x * xyz(block.cameraRight) +
                                       p.y * xyz(block.cameraUp))};
}

}  // namespace vitrine::test
