// SPDX-License-Identifier: MIT
// For tests: glTF files built in memory, and a folder to read them from.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <span>

#include "gltf/read.hpp"
#include "image/png.hpp"

namespace vitrine {

inline void append32(std::string& to, uint32_t value) {
    to.append(reinterpret_cast<const char*>(&value), sizeof value);
}

inline std::string glbChunk(const char* type, std::string content, char padding) {
    content.resize((content.size() + 3) / 4 * 4, padding);
    std::string chunk;
    append32(chunk, static_cast<uint32_t>(content.size()));
    return chunk.append(type, 4) + content;
}

inline std::string glbOf(const std::string& chunks) {
    std::string bytes = "glTF";
    append32(bytes, 2);
    append32(bytes, static_cast<uint32_t>(12 + chunks.size()));
    return bytes + chunks;
}

inline std::string base64(std::string_view bytes) {
    constexpr char kAlphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t bits = 0;
        for (size_t k = 0; k < 3; ++k)
            bits = bits << 8 | (i + k < bytes.size() ? static_cast<uint8_t>(bytes[i + k]) : 0u);
        for (size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : kAlphabet[bits >> (18 - 6 * k) & 63];
    }
    return text;
}

/// JSON and one buffer that grows.
struct TestModel {
    nlohmann::json json = {{"asset", {{"version", "2.0"}}}};
    std::string binary;

    /// Index of the new bufferView.
    template <typename T>
    size_t addView(const std::vector<T>& data, int stride = 0) {
        binary.resize((binary.size() + 3) / 4 * 4);
        nlohmann::json view{
            {"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", data.size() * sizeof(T)}};
        if (stride != 0) view["byteStride"] = stride;
        binary.append(reinterpret_cast<const char*>(data.data()), data.size() * sizeof(T));
        return add("bufferViews", view);
    }
    /// Index of the new object in one of the file's arrays.
    size_t add(const char* array, const nlohmann::json& object) {
        json[array].push_back(object);
        return json[array].size() - 1;
    }
    /// Index of the new accessor; `more` is merged into it.
    template <typename T>
    size_t addAccessor(const std::vector<T>& data, const char* type, size_t count,
                       const nlohmann::json& more = {}) {
        nlohmann::json accessor{{"bufferView", addView(data)},
                                {"componentType", componentType<T>()},
                                {"type", type},
                                {"count", count}};
        if (more.is_object()) accessor.update(more);
        return add("accessors", accessor);
    }
    template <typename T>
    static int componentType() {
        if constexpr (std::is_same_v<T, int8_t>) return 5120;
        if constexpr (std::is_same_v<T, uint8_t>) return 5121;
        if constexpr (std::is_same_v<T, int16_t>) return 5122;
        if constexpr (std::is_same_v<T, uint16_t>) return 5123;
        if constexpr (std::is_same_v<T, uint32_t>) return 5125;
        return 5126;
    }

    [[nodiscard]] nlohmann::json finished() const {
        nlohmann::json result = json;
        if (!binary.empty() && !result.contains("buffers"))
            result["buffers"] = {{{"byteLength", binary.size()}}};
        return result;
    }
    [[nodiscard]] std::string glb() const {
        const std::string binaryChunk = binary.empty() ? "" : glbChunk("BIN\0", binary, '\0');
        return glbOf(glbChunk("JSON", finished().dump(), ' ') + binaryChunk);
    }
    /// With the buffer as a data: URI.
    [[nodiscard]] std::string gltf(int indent = -1) const {
        nlohmann::json result = finished();
        if (!binary.empty() && !result["buffers"][0].contains("uri"))
            result["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(binary);
        return result.dump(indent);
    }
};

/// Accessors 0 and 1 are the positions and indices of one upright unit square, seen from +z.
inline TestModel square() {
    TestModel model;
    model.addAccessor<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, "VEC3", 4);
    model.addAccessor<uint16_t>({0, 1, 2, 0, 2, 3}, "SCALAR", 6);
    model.add("meshes", nlohmann::json::parse(R"({"primitives": [
        {"attributes": {"POSITION": 0}, "indices": 1}]})"));
    model.add("nodes", {{"mesh", 0}});
    model.add("scenes", {{"nodes", {0}}});
    return model;
}

/// One of everything, for tests that break one thing of it. Needs no other file.
inline TestModel oneOfEach() {
    TestModel model = square();  // accessors 0: positions, 1: indices
    const auto parse = [](const char* text) { return nlohmann::json::parse(text); };
    model.addAccessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 4);  // 2: normals
    model.addAccessor<float>({0, 0, 1, 0, 1, 1, 0, 1}, "VEC2", 4);              // 3: uvs
    model.addAccessor<float>({0, 1}, "SCALAR", 2);                              // 4: times
    model.addAccessor<float>({0, 0, 0, 1, 0, 0, 0, 1}, "VEC4", 2);              // 5: rotations
    model.json["accessors"][3]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", model.addView<uint16_t>({2, 3})}, {"componentType", 5123}}},
        {"values", {{"bufferView", model.addView<float>({0.5f, 0.5f, 0, 0})}}}};
    model.json["meshes"] = parse(R"([{"primitives": [{"indices": 1, "material": 0,
        "attributes": {"POSITION": 0, "NORMAL": 2, "TEXCOORD_0": 3}}]}])");
    const auto png = encodePng(ImageRgba8(1, 1));
    model.json["images"] = {
        {{"uri", "data:image/png;base64," + base64(std::string(png.begin(), png.end()))}}};
    model.json["samplers"] = parse(R"([{"wrapS": 33071, "magFilter": 9729, "minFilter": 9987}])");
    model.json["textures"] = parse(R"([{"source": 0, "sampler": 0}])");
    model.json["materials"] = parse(R"([{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}},
        "extensions": {"KHR_materials_sheen": {"sheenColorTexture": {"index": 0}}}}])");
    model.json["cameras"] = parse(R"([{"type": "perspective",
        "perspective": {"yfov": 1, "znear": 0.1}}])");
    model.json["extensions"] = parse(R"({"KHR_lights_punctual": {"lights": [{"type": "spot",
        "spot": {"outerConeAngle": 0.5}}]}})");
    model.json["extensionsUsed"] = {"KHR_lights_punctual", "KHR_materials_sheen"};
    model.json["nodes"] = parse(R"([{"mesh": 0, "children": [1]},
        {"camera": 0, "extensions": {"KHR_lights_punctual": {"light": 0}}, "children": [2]}, {}])");
    model.json["scene"] = 0;
    model.json["animations"] = parse(R"([{"samplers": [{"input": 4, "output": 5}],
        "channels": [{"sampler": 0, "target": {"node": 0, "path": "rotation"}}]}])");
    model.json["buffers"] = {{{"byteLength", model.binary.size()}}};
    return model;
}

class GltfTest : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = std::filesystem::temp_directory_path() / "vitrine-gltf-XXXXXX";
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        folder = name;
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    void write(const std::string& name, const std::string& bytes) const {
        // Some file systems wait for the disk when a file is overwritten, but not for a new one.
        std::filesystem::remove(folder / name);
        std::ofstream(folder / name, std::ios::binary) << bytes;
    }
    /// Reads bytes as a file. `messages` is then what was said about it, without the folder.
    std::optional<GltfModel> read(const std::string& bytes, const std::string& name = "m.glb",
                                  const GltfLimits& limits = {}) {
        write(name, bytes);
        Diagnostics diagnostics;
        auto model = readGltf(folder / name, diagnostics, limits);
        EXPECT_EQ(model.has_value(), !diagnostics.hasErrors());
        messages = diagnostics.text();
        const std::string prefix = folder.string() + "/";
        for (size_t at; (at = messages.find(prefix)) != std::string::npos;)
            messages.erase(at, prefix.size());
        return model;
    }
    /// A model that must be read without any message.
    GltfModel readGood(const TestModel& model) {
        auto result = read(model.glb());
        EXPECT_EQ(messages, "");
        return result ? std::move(*result) : GltfModel{};
    }

    std::filesystem::path folder;
    std::string messages;
};

}  // namespace vitrine
