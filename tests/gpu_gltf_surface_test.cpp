// SPDX-License-Identifier: MIT
// The surfaces of glTF models: tangents, coordinates, colours, texels.
#include <set>

#include "gpu_gltf_support.hpp"

namespace vitrine {
namespace {

TEST_F(GltfPictureTest, TangentsByFormulaByFileAndByTriangleAgree) {
    const Mesh sphere = makeSphere(1, 48);
    const ImageRgba8 given = draw(modelOf(withParallels(sphere), textured()), View::kNormal);
    const ImageRgba8 generated = draw(modelOf(sphere, textured()), View::kNormal);
    write("ball.obj", objOf(sphere));
    const ImageRgba8 byTriangle = draw(R"([material.m]
normal_texture = "normal.png"
[shape.s]
mesh = "ball.obj"
[[node]]
shape = "s"
material = "m"
)",
                                       View::kNormal);
    expectSame(given, generated);
    // Triangles have one direction each, which is off by half of their width: 2 degrees.
    EXPECT_LT(compareImages(given, byTriangle, 12).fractionOver, 0.01);
    expectDifferent(given, draw(modelOf(sphere, textured({}, false)), View::kNormal));
}

TEST_F(GltfPictureTest, SeenFromBehindABumpIsADent) {
    // Its back is the front of a plane that faces away, with all slopes reversed.
    Mesh plane = makePlane(1, 1);
    plane.tangents.assign(4, {1, 0, 0, 1});
    TestModel model = modelOf(plane, textured());
    model.json["nodes"][0]["rotation"] = quaternion(180, {1, 0, 0});
    Mesh turned = plane;
    for (glm::vec3& n : turned.normals) n = -n;
    turned.tangents.assign(4, {1, 0, 0, -1});
    for (glm::uvec3& t : turned.triangles) std::swap(t.y, t.z);
    json reversed = textured();
    reversed["normalTexture"]["scale"] = -1;
    TestModel other = modelOf(turned, reversed);
    other.json["nodes"] = model.json["nodes"];
    expectSame(draw(model, View::kNormal), draw(other, View::kNormal));
    expectDifferent(draw(model, View::kNormal), draw(modelOf(turned, textured()), View::kNormal));
}

TEST_F(GltfPictureTest, TextureTransformsAreTransformedCoordinates) {
    const Mesh plane = makePlane(1, 1);
    const json transform = {{"offset", {0.3, -0.2}}, {"rotation", 0.6}, {"scale", {2, 1.5}}};
    TestModel model =
        modelOf(plane, textured({{"extensions", {{"KHR_texture_transform", transform}}}}, false));
    model.json["extensionsUsed"] = {"KHR_texture_transform"};
    Mesh moved = plane;
    for (glm::vec2& uv : moved.uvs) {
        const float u = 2 * uv.x, v = 1.5f * (1 - uv.y);  // as in the file, downwards
        uv = {0.3f + std::cos(0.6f) * u + std::sin(0.6f) * v,
              1 - (-0.2f - std::sin(0.6f) * u + std::cos(0.6f) * v)};
    }
    const ImageRgba8 picture = draw(model, View::kAlbedo);
    expectSame(picture, draw(modelOf(moved, textured({}, false)), View::kAlbedo));
    expectDifferent(picture, draw(modelOf(plane, textured({}, false)), View::kAlbedo));
}

TEST_F(GltfPictureTest, TheSecondCoordinatesAreAsGoodAsTheFirst) {
    const Mesh plane = makePlane(1, 1);
    Mesh second = plane;
    second.uvs2 = plane.uvs;
    for (glm::vec2& uv : second.uvs) uv = {uv.y * 3, 0.2f};
    for (const View view : {View::kAlbedo, View::kNormal}) {
        const ImageRgba8 expected = draw(modelOf(plane, textured()), view);
        expectSame(draw(modelOf(second, textured({{"texCoord", 1}})), view), expected);
        expectDifferent(draw(modelOf(second, textured()), view), expected);
    }
}

TEST_F(GltfPictureTest, ColoursOfVerticesMultiplyTheMaterials) {
    Mesh plane = makePlane(1, 1);
    json material{{"pbrMetallicRoughness", {{"metallicFactor", 0}}}};
    json& pbr = material["pbrMetallicRoughness"];
    pbr["baseColorFactor"] = {0.1, 0.4, 0.02, 1};
    const ImageRgba8 expected = draw(modelOf(plane, material));
    plane.colors.assign(4, {0.2f, 0.5f, 0.04f, 1});
    pbr["baseColorFactor"] = {0.5, 0.8, 0.5, 1};
    expectSame(draw(modelOf(plane, material)), expected);
    expectDifferent(draw(modelOf(makePlane(1, 1), material)), expected);
}

TEST_F(GltfPictureTest, TheNearestTexelIsNotBlended) {
    const Mesh plane = makePlane(3, 3);  // magnified, or there are smaller pictures to blend
    TestModel model = modelOf(plane, textured({}, false));
    model.json["samplers"] = {{{"magFilter", 9728}, {"minFilter", 9728}}};
    model.json["textures"][0]["sampler"] = 0;
    std::set<std::array<int, 3>> texels;
    const ImageRgba8 source = randomPicture(false);
    for (size_t i = 0; i < source.pixels.size(); i += 4)
        texels.insert({source.pixels[i], source.pixels[i + 1], source.pixels[i + 2]});
    const auto shareOfTexels = [&](const ImageRgba8& image) {
        double seen = 0, pure = 0;
        for (size_t i = 0; i < image.pixels.size(); i += 4) {
            const std::array<int, 3> c{image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]};
            if (c == std::array<int, 3>{}) continue;
            ++seen;
            for (const auto& t : texels)
                if (std::abs(t[0] - c[0]) + std::abs(t[1] - c[1]) + std::abs(t[2] - c[2]) <= 6) {
                    ++pure;
                    break;
                }
        }
        EXPECT_GT(seen, 3000);
        return pure / seen;
    };
    EXPECT_GT(shareOfTexels(draw(model, View::kAlbedo)), 0.98);
    model.json.erase("samplers");
    model.json["textures"][0].erase("sampler");
    EXPECT_LT(shareOfTexels(draw(model, View::kAlbedo)), 0.3);
}

}  // namespace
}  // namespace vitrine
