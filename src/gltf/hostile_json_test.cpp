// SPDX-License-Identifier: MIT
// One thing after another in a good file is broken, and must be refused with its place.
#include "gltf/test_model.hpp"

namespace vitrine {
namespace {

using Json = nlohmann::json;
using GltfHostileJson = GltfTest;

/// What `path` is set to (nothing: it is removed), and a part of the message.
struct Break {
    const char* path;
    const char* value;
    const char* message;
};

constexpr const char* kNoPlaceForBytes = "are not inside of the buffer's";

const Break kBreaks[] = {
    {"/asset", nullptr, "'asset' is missing"},
    {"/asset/version", nullptr, "/asset/version: version '' is not supported"},
    {"/asset/version", R"("1.0")", "/asset/version: version '1.0' is not supported"},
    {"/asset/version", R"("3.0")", "version '3.0' is not supported"},
    {"/asset/version", R"("2")", "version '2' is not supported"},
    {"/asset/version", R"("2.0 beta")", "version '2.0 beta' is not supported"},
    {"/asset/version", "2.0", "/asset/version: must be a string"},
    {"/asset/minVersion", R"("2.1")", "/asset/minVersion: version '2.1' is not supported"},
    {"/extensionsRequired", R"(["KHR_draco_mesh_compression"])", "'KHR_draco_mesh_compression'"},
    {"/extensionsRequired", R"(["a", "b"])", "the extension 'b', which is not supported"},
    {"/extensionsRequired", R"([7])", "/extensionsRequired/0: must be a string"},
    {"/extensionsUsed", R"({})", "/extensionsUsed: must be an array"},

    {"/buffers", nullptr, "/bufferViews/0/buffer: 0 is out of range: there are none"},
    {"/buffers", "{}", "/buffers: must be an array"},
    {"/buffers/0", "3", "/buffers/0: must be an object"},
    {"/buffers/0/byteLength", nullptr, "/buffers/0: 'byteLength' is missing"},
    {"/buffers/0/byteLength", "0", "/buffers/0/byteLength: 0 bytes are declared"},
    {"/buffers/0/byteLength", "100000", "/buffers/0/byteLength: 100000 bytes are declared, but"},
    {"/buffers/0/byteLength", "20", kNoPlaceForBytes},
    {"/buffers/0/byteLength", "1e300", "/buffers/0/byteLength: must be a whole number"},
    {"/buffers/0/byteLength", "18446744073709551615", "/buffers/0/byteLength: must be a whole"},
    {"/buffers/0/byteLength", "-1", "/buffers/0/byteLength: must be a whole number"},

    {"/bufferViews/0/buffer", nullptr, "/bufferViews/0: 'buffer' is missing"},
    {"/bufferViews/0/buffer", "1", "/bufferViews/0/buffer: 1 is out of range: the last one is 0"},
    {"/bufferViews/0/buffer", "-1", "/bufferViews/0/buffer: must be a whole number"},
    {"/bufferViews/0/buffer", "0.5", "/bufferViews/0/buffer: must be a whole number"},
    {"/bufferViews/0/buffer", "4294967296", "/bufferViews/0/buffer: 4294967296 is out of range"},
    {"/bufferViews/0/byteLength", nullptr, "/bufferViews/0: 'byteLength' is missing"},
    {"/bufferViews/0/byteLength", "0", "/bufferViews/0: bytes 0 to 0 are not inside"},
    {"/bufferViews/0/byteLength", "9007199254740992", kNoPlaceForBytes},
    {"/bufferViews/0/byteLength", "18446744073709551615", "/bufferViews/0/byteLength: must be a"},
    {"/bufferViews/0/byteOffset", "9007199254740992", kNoPlaceForBytes},
    {"/bufferViews/0/byteOffset", "18446744073709551568", "/bufferViews/0/byteOffset: must be a"},
    {"/bufferViews/0/byteOffset", "-4", "/bufferViews/0/byteOffset: must be a whole number"},
    {"/bufferViews/0/byteOffset", "2",
     "/accessors/0/byteOffset: 0 (byte 2 of the buffer) is not a"},
    {"/bufferViews/0/byteStride", "0",
     "/bufferViews/0/byteStride: 0 is not a multiple of 4 from 4"},
    {"/bufferViews/0/byteStride", "13", "/bufferViews/0/byteStride: 13 is not a multiple of 4"},
    {"/bufferViews/0/byteStride", "256", "/bufferViews/0/byteStride: 256 is not"},
    {"/bufferViews/0/byteStride", "8",
     "an element has 12 bytes, but the bufferView's byteStride is 8"},
    {"/bufferViews/0/byteStride", "16",
     "/accessors/0: 4 elements end at byte 60 of a bufferView of 48"},

    {"/accessors", nullptr, "/meshes/0/primitives/0/attributes/POSITION: 0 is out of range"},
    {"/accessors/0/bufferView", "99", "/accessors/0/bufferView: 99 is out of range"},
    {"/accessors/0/componentType", nullptr, "/accessors/0: 'componentType' is missing"},
    {"/accessors/0/componentType", "5124", "/accessors/0/componentType: 5124 is no component type"},
    {"/accessors/0/componentType", "70662", "70662 is no component type"},
    {"/accessors/0/type", nullptr, "/accessors/0/type: '' is no type of accessor"},
    {"/accessors/0/type", R"("VEC5")", "/accessors/0/type: 'VEC5' is no type"},
    {"/accessors/0/type", R"("VEC4")", "/accessors/0: 4 elements end at byte 64"},
    {"/accessors/0/type", R"("VEC2")", "attributes/POSITION: the accessor must be a VEC3"},
    {"/accessors/0/type", R"("MAT4")", "/accessors/0: 4 elements end at byte 256"},
    {"/accessors/0/count", nullptr, "/accessors/0: 'count' is missing"},
    {"/accessors/0/count", "0", "/accessors/0/count: 0 is not from 1"},
    {"/accessors/0/count", "5", "/accessors/0: 5 elements end at byte 60"},
    {"/accessors/0/count", "3", "/indices: index 3 at 5 is out of range: there are 3 vertices"},
    {"/accessors/0/count", "4294967295", "/accessors/0: 4294967295 elements end at byte"},
    {"/accessors/0/count", "4294967300", "/accessors/0/count: 4294967300 is not from 1 to 2^32"},
    {"/accessors/0/byteOffset", "4", "/accessors/0: 4 elements end at byte 52"},
    {"/accessors/0/byteOffset", "1", "/accessors/0/byteOffset: 1 (byte 1 of the buffer) is not a"},
    {"/accessors/0/byteOffset", "9007199254740992", "/accessors/0: 4 elements end at byte"},
    {"/accessors/0/normalized", "true", "/accessors/0/normalized: only bytes and shorts"},
    {"/accessors/0/normalized", "1", "/accessors/0/normalized: must be true or false"},
    {"/accessors/1/componentType", "5122",
     "/meshes/0/primitives/0/indices: the accessor must be a"},
    {"/accessors/1/normalized", "true", "/meshes/0/primitives/0/indices: the accessor must be a"},
    {"/accessors/1/byteOffset", "2", "/accessors/1: 6 elements end at byte 14"},
    {"/accessors/2/count", "3", "attributes/NORMAL: 3 elements, but there are 4 positions"},
    {"/accessors/2/type", R"("VEC2")", "attributes/NORMAL: the accessor must be a VEC3"},
    {"/accessors/3/componentType", "5125", "attributes/TEXCOORD_0: the accessor's type is not"},

    {"/accessors/3/sparse", "[]", "/accessors/3/sparse: must be an object"},
    {"/accessors/3/sparse/count", nullptr, "/accessors/3/sparse: 'count' is missing"},
    {"/accessors/3/sparse/count", "0", "/accessors/3/sparse/count: 0 is not from 1"},
    {"/accessors/3/sparse/count", "5", "/accessors/3/sparse/count: 5 elements of 4"},
    {"/accessors/3/sparse/count", "3", "/accessors/3/sparse/indices: 3 elements end at byte 6"},
    {"/accessors/3/sparse/indices", nullptr, "'indices' and 'values' must both be there"},
    {"/accessors/3/sparse/values", nullptr, "'indices' and 'values' must both be there"},
    {"/accessors/3/sparse/indices/bufferView", nullptr, "indices: 'bufferView' is missing"},
    {"/accessors/3/sparse/indices/componentType", "5126", "indices are whole numbers"},
    {"/accessors/3/sparse",
     R"({"count": 2, "indices": {"bufferView": 2, "componentType": 5121}, "values": {"bufferView": 7}})",
     "/accessors/3/sparse/indices: index 0 at 1 does not grow"},
    {"/accessors/3/count", "2",
     "/accessors/3/sparse/indices: index 2 at 0 is out of range: there are 2"},
    {"/accessors/3/sparse/values/bufferView", "77", "values/bufferView: 77 is out of range"},
    {"/accessors/3/sparse/values/byteOffset", "12", "values: 1 elements end at byte 20"},

    {"/meshes/0/primitives", nullptr, "/meshes/0: 'primitives' is missing"},
    {"/meshes/0/primitives", "[]", "/meshes/0: 'primitives' is missing"},
    {"/meshes/0/primitives/0", "[]", "/meshes/0/primitives/0: must be an object"},
    {"/meshes/0/primitives/0/attributes", nullptr,
     "/meshes/0/primitives/0: 'attributes' is missing"},
    {"/meshes/0/primitives/0/attributes/POSITION", "1",
     "attributes/POSITION: the accessor must be"},
    {"/meshes/0/primitives/0/attributes/POSITION", R"("0")", "POSITION: must be a whole number"},
    {"/meshes/0/primitives/0/attributes/NORMAL", "12", "attributes/NORMAL: 12 is out of range"},
    {"/meshes/0/primitives/0/attributes/TANGENT", "0",
     "attributes/TANGENT: the accessor must be a V"},
    {"/meshes/0/primitives/0/attributes/COLOR_0", "1", "attributes/COLOR_0: the accessor must be"},
    {"/meshes/0/primitives/0/indices", "0", "/meshes/0/primitives/0/indices: the accessor must be"},
    {"/meshes/0/primitives/0/indices", "6", "/meshes/0/primitives/0/indices: 6 is out of range"},
    {"/meshes/0/primitives/0/indices", "-1", "/meshes/0/primitives/0/indices: must be a whole"},
    {"/meshes/0/primitives/0/material", "1", "/meshes/0/primitives/0/material: 1 is out of range"},
    {"/meshes/0/primitives/0/mode", "7", "/meshes/0/primitives/0/mode: 7 is not from 0 to 6"},

    {"/images/0/uri", nullptr, "/images/0: either 'uri' or 'bufferView' must be there"},
    {"/images/0/bufferView", "0", "/images/0: either 'uri' or 'bufferView' must be there"},
    {"/images/0/uri", "7", "/images/0/uri: must be a string"},
    {"/samplers/0/wrapS", "1", "/samplers/0/wrapS: 1 is no way to wrap"},
    {"/samplers/0/magFilter", "9987", "/samplers/0/magFilter: 9987 is no magnification filter"},
    {"/samplers/0/minFilter", "0", "/samplers/0/minFilter: 0 is no minification filter"},
    {"/textures/0/source", "1", "/textures/0/source: 1 is out of range"},
    {"/textures/0/sampler", "1", "/textures/0/sampler: 1 is out of range"},
    {"/materials/0/alphaMode", R"("FADE")", "/materials/0/alphaMode: 'FADE' is none of"},
    {"/materials/0/pbrMetallicRoughness/baseColorTexture/index", "1", "Texture/index: 1 is out of"},
    {"/materials/0/pbrMetallicRoughness/baseColorTexture/index", nullptr, "'index' is missing"},
    {"/materials/0/pbrMetallicRoughness/baseColorFactor", "[1, 1]", "must have 4 numbers, not 2"},
    {"/materials/0/pbrMetallicRoughness", "1",
     "/materials/0/pbrMetallicRoughness: must be an object"},
    {"/materials/0/extensions/KHR_materials_sheen/sheenColorTexture/index", "9",
     "9 is out of range"},
    {"/materials/0/emissiveFactor", R"([1, "2", 3])",
     "/materials/0/emissiveFactor/1: must be a num"},
    {"/materials/0/doubleSided", "0", "/materials/0/doubleSided: must be true or false"},
    {"/cameras/0/type", R"("fisheye")", "/cameras/0/type: 'fisheye' is neither"},
    {"/cameras/0/perspective/yfov", nullptr, "/cameras/0/perspective: 'yfov' is missing"},
    {"/cameras/0/perspective", nullptr, "/cameras/0/perspective: 'yfov' is missing"},
    {"/extensions/KHR_lights_punctual/lights/0/type", R"("laser")", "'laser' is none of"},
    {"/extensions/KHR_lights_punctual/lights/0/color", "[1]", "must have 3 numbers, not 1"},

    {"/nodes/0/mesh", "1", "/nodes/0/mesh: 1 is out of range"},
    {"/nodes/1/camera", "1", "/nodes/1/camera: 1 is out of range"},
    {"/nodes/1/extensions/KHR_lights_punctual/light", "1", "light: 1 is out of range"},
    {"/nodes/0/children/0", "3", "/nodes/0/children/0: 3 is out of range"},
    {"/nodes/0/children/0", "0", "/nodes/0: the node is its own ancestor"},
    {"/nodes/2/children", "[0]", "/nodes/0: the node is its own ancestor"},
    {"/nodes/2/children", "[1]", "/nodes/2/children: node 1 has another parent already: node 0"},
    {"/nodes/0/children", "[1, 1]", "/nodes/0/children: node 1 has another parent already"},
    {"/nodes/0/children", R"("1")", "/nodes/0/children: must be an array"},
    {"/nodes/0/translation", "[1, 2]", "/nodes/0/translation: must have 3 numbers"},
    {"/nodes/0/translation", "[1, 2, null]", "/nodes/0/translation/2: must be a number"},
    {"/nodes/0/matrix", "[1, 0]", "/nodes/0/matrix: must have 16 numbers"},
    {"/scene", "1", "/scene: 1 is out of range"},
    {"/scenes/0/nodes", "[3]", "/scenes/0/nodes/0: 3 is out of range"},
    {"/scenes/0/nodes", "[1]", "/scenes/0/nodes: node 1 is no root: its parent is node 0"},
    {"/scenes/0/nodes", "[0, 0]", "/scenes/0/nodes: a node comes twice"},

    {"/animations/0/channels/0/sampler", "1",
     "/animations/0/channels/0/sampler: 1 is out of range"},
    {"/animations/0/channels/0/sampler", nullptr, "/animations/0/channels/0: 'sampler' is missing"},
    {"/animations/0/channels/0/target/node", "3", "/target/node: 3 is out of range"},
    {"/animations/0/samplers/0/input", nullptr, "/animations/0/samplers/0: 'input' is missing"},
    {"/animations/0/samplers/0/input", "0", "input: the accessor must be a SCALAR of floats"},
    {"/animations/0/samplers/0/output", "0", "output: the accessor must be a VEC4"},
    {"/animations/0/samplers/0/output", "99", "output: 99 is out of range"},
    {"/animations/0/samplers/0/interpolation", R"("CUBIC")", "'CUBIC' is none of"},
    {"/animations/0/samplers/0/interpolation", R"("CUBICSPLINE")",
     "2 elements for 2 times; 3 a time"},
    {"/accessors/4/count", "1", "output: 2 elements for 1 times"},
};

std::string patched(const TestModel& model, const Break& broken) {
    Json json = model.finished();
    const Json::json_pointer path(broken.path);
    if (broken.value == nullptr)
        json.at(path.parent_pointer()).erase(path.back());
    else
        json[path] = Json::parse(broken.value);
    return glbOf(glbChunk("JSON", json.dump(), ' ') + glbChunk("BIN\0", model.binary, '\0'));
}

TEST_F(GltfHostileJson, TheUnbrokenFileIsGood) {
    const GltfModel read = readGood(oneOfEach());
    EXPECT_EQ(read.meshes.at(0).primitives.at(0).mesh.uvs[2], glm::vec2(0.5f, 0.5f));
    EXPECT_EQ(read.images.at(0).width, 1);
    EXPECT_EQ(read.animations.at(0).channels.size(), 1u);
}

TEST_F(GltfHostileJson, EveryBreakIsRefusedWithItsPlace) {
    const TestModel model = oneOfEach();
    for (const Break& broken : kBreaks) {
        SCOPED_TRACE(std::string(broken.path) + " = " +
                     (broken.value ? broken.value : "(removed)"));
        EXPECT_FALSE(read(patched(model, broken)));
        EXPECT_EQ(messages.substr(0, 7), "m.glb: ");
        EXPECT_NE(messages.find(broken.message), std::string::npos) << messages;
    }
}

TEST_F(GltfHostileJson, ManyErrorsAreReportedAtOnceButNotAll) {
    TestModel model = square();
    model.json["nodes"][0]["mesh"] = 7;
    model.json["accessors"][1]["count"] = 5000;
    model.json["scene"] = "first";
    EXPECT_FALSE(read(model.gltf(1), "m.gltf"));
    EXPECT_EQ(std::count(messages.begin(), messages.end(), '\n'), 2) << messages;
    for (const char* text : {"m.gltf:9:3: error: /accessors/1: 5000 elements",
                             "error: /nodes/0/mesh: 7", "error: /scene: must be a whole number"})
        EXPECT_NE(messages.find(text), std::string::npos) << messages;

    for (int i = 0; i < 100; ++i) model.json["nodes"].push_back({{"mesh", -1}});
    EXPECT_FALSE(read(model.glb()));
    EXPECT_EQ(std::count(messages.begin(), messages.end(), '\n'), 20) << messages;
    EXPECT_NE(messages.find("too many errors; reading ends here"), std::string::npos);
}

TEST_F(GltfHostileJson, WarningsAreLimitedToo) {
    TestModel model;
    for (int i = 0; i < 100; ++i) model.add("nodes", {{"scale", {0, 0, 0}}});
    EXPECT_TRUE(read(model.glb()));
    EXPECT_EQ(std::count(messages.begin(), messages.end(), '\n'), 20) << messages;
    EXPECT_NE(messages.find("m.glb: warning: further warnings are not shown"), std::string::npos);
}

}  // namespace
}  // namespace vitrine
