// SPDX-License-Identifier: MIT
// Broken containers, forbidden references and bombs: everything wrong with a file before its
// content. What is wrong inside of the JSON is in hostile_json_test.cpp.
#include <sys/resource.h>
#include <sys/stat.h>

#include <chrono>

#include "gltf/test_model.hpp"

namespace vitrine {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class GltfHostileFiles : public GltfTest {
  protected:
    void expectRefused(const std::string& bytes, const std::string& message,
                       const std::string& name = "m.glb") {
        SCOPED_TRACE(message);
        const auto start = std::chrono::steady_clock::now();
        EXPECT_FALSE(read(bytes, name));
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
        EXPECT_NE(messages.find(message), std::string::npos) << messages;
    }
    /// As a buffer, and as a picture.
    void expectUriRefused(const std::string& uri, const std::string& message) {
        TestModel buffer;
        buffer.json["buffers"] = {{{"byteLength", 4}, {"uri", uri}}};
        expectRefused(buffer.json.dump(), "error: /buffers/0/uri: ", "m.gltf");
        EXPECT_NE(messages.find(message), std::string::npos) << messages;
        TestModel image;
        image.json["images"] = {{{"uri", uri}}};
        expectRefused(image.json.dump(), "error: /images/0/uri: ", "m.gltf");
    }
};

long peakKib() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

TEST_F(GltfHostileFiles, EveryTruncationIsRefused) {
    TestModel model = square();
    model.json["meshes"][0]["name"] = "a longer one";
    const std::string bytes = model.glb(), text = model.gltf();
    ASSERT_TRUE(read(bytes)) << messages;
    for (size_t length = 0; length < bytes.size(); ++length) {
        ASSERT_FALSE(read(bytes.substr(0, length))) << length;
        ASSERT_NE(messages.find("m.glb"), std::string::npos);
        if (length >= 4) {
            ASSERT_NE(messages.find("(at byte "), std::string::npos) << messages;
        }
    }
    for (size_t length = 0; length < text.size(); ++length)
        ASSERT_FALSE(read(text.substr(0, length), "m.gltf")) << length;
}

TEST_F(GltfHostileFiles, LengthsInTheContainerMayNotLie) {
    const std::string good = square().glb();
    const auto with = [&good](size_t byte, uint32_t value) {
        std::string bytes = good;
        std::memcpy(bytes.data() + byte, &value, sizeof value);
        return bytes;
    };
    const auto jsonLength = static_cast<uint32_t>(square().finished().dump().size() + 3) / 4 * 4;
    const size_t binary = 20 + jsonLength;
    const std::string json = glbChunk("JSON", square().finished().dump(), ' ');
    expectRefused(with(4, 1), "GLB: version 1 is not supported, only 2 is (at byte 4)");
    expectRefused(with(4, 0xffffffff), "is not supported, only 2 is (at byte 4)");
    expectRefused(with(8, 0xffffffff), "of the 4294967295 it declares (at byte 8)");
    expectRefused(with(8, 0), "but declares 0 (at byte 8)");
    expectRefused(with(12, 0xffffffff), "a chunk declares 4294967295 bytes, but only");
    expectRefused(with(12, 0xfffffffc), "(at byte 12)");
    expectRefused(with(12, jsonLength - 2), "not a multiple of 4 (at byte 12)");
    expectRefused(with(12, jsonLength - 4), "bytes, but only");
    expectRefused(with(16, 0x004e4942), "the first chunk, and no other, must be JSON (at byte 16)");
    expectRefused(with(binary, 0x7ffffffc), "bytes, but only");
    expectRefused(with(binary + 4, 0x4e4f534a), "the first chunk, and no other, must be JSON");
    expectRefused(glbOf(""), "there is no JSON chunk (at byte 12)");
    expectRefused(glbOf("abc"), "the header of a chunk is cut short (at byte 12)");
    expectRefused(glbOf(glbChunk("JSON", "", ' ')), "JSON: syntax error");
    expectRefused(glbOf(json), "there is no binary chunk for this buffer");
    expectRefused(glbOf(json + glbChunk("BIN\0", "", '\0')), "byteLength: 60 bytes are declared");
    const std::string extra = glbChunk("XTRA", "anything", ' ');
    expectRefused(glbOf(json + extra + glbChunk("BIN\0", "", '\0')),
                  "only the second chunk may be");
    EXPECT_TRUE(read(glbOf(good.substr(12) + extra))) << messages;
}

TEST_F(GltfHostileFiles, NothingOutsideOfTheFolderIsRead) {
    const fs::path outside = folder;
    fs::create_directory(folder / "model");
    folder = outside / "model";
    std::ofstream(outside / "secret.png") << "secret";
    fs::create_symlink(outside / "secret.png", folder / "link.png");
    fs::create_directory_symlink(outside, folder / "up");
    expectUriRefused("../secret.png", "leads out");
    expectUriRefused("a/../../secret.png", "leads out");
    expectUriRefused("%2e%2e/secret.png", "leads out");
    expectUriRefused("..%2Fsecret.png", "leads out");
    expectUriRefused("%2E%2E%2fsecret.png", "leads out");
    expectUriRefused((outside / "secret.png").string(), "the path is absolute");
    expectUriRefused("%2Fetc%2Fhostname", "the path is absolute");
    expectUriRefused("//server/share", "the path is absolute");
    expectUriRefused("..\\secret.png", "separated by '/'");
    expectUriRefused("..%5csecret.png", "separated by '/'");
    expectUriRefused("link.png", "leads out");
    expectUriRefused("up/secret.png", "leads out");
    expectUriRefused("file:///etc/hostname", "only files in the model's own folder");
    expectUriRefused("http://127.0.0.1/a", "only files in the model's own folder");
    expectUriRefused("C:/a.png", "only files in the model's own folder");
    expectUriRefused("a%00.png", "zero byte");
    expectUriRefused("", "the file name is empty");
    expectUriRefused("%2", "two hexadecimal digits");
    expectUriRefused(std::string(100000, 'a'), "the file name is too long");
    expectUriRefused("data:;base64,A", "cut short");
    expectUriRefused("data:;base64,A*==", "not allowed");
    expectUriRefused("data:,hello", "must be in base64");
    folder = outside;
}

TEST_F(GltfHostileFiles, LinksInsideOfTheFolderAreFine) {
    TestModel model = square();
    std::ofstream(folder / "real.bin") << model.binary;
    fs::create_symlink("real.bin", folder / "link.bin");
    model.json["buffers"] = {{{"byteLength", model.binary.size()}, {"uri", "link.bin"}}};
    EXPECT_TRUE(read(model.json.dump(), "m.gltf")) << messages;
}

TEST_F(GltfHostileFiles, OnlyRegularFilesAreRead) {
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    fs::create_directory(folder / "folder");
    for (const char* name : {"pipe", "folder", "."}) {
        Diagnostics diagnostics;
        EXPECT_FALSE(readGltf(folder / name, diagnostics));
        EXPECT_NE(diagnostics.text().find("not a regular file"), std::string::npos);
        TestModel buffer;
        buffer.json["buffers"] = {{{"byteLength", 4}, {"uri", name}}};
        expectRefused(buffer.json.dump(), "not a regular file", "m.gltf");
        TestModel image;
        image.json["images"] = {{{"uri", name}}};
        EXPECT_TRUE(read(image.json.dump(), "m.gltf"));
        EXPECT_NE(messages.find("warning: /images/0: not a regular file"), std::string::npos);
    }
    Diagnostics diagnostics;
    EXPECT_FALSE(readGltf(folder / "missing.glb", diagnostics));
    EXPECT_NE(diagnostics.text().find("missing.glb: error: cannot read"), std::string::npos);
    TestModel buffer;
    buffer.json["buffers"] = {{{"byteLength", 4}, {"uri", "missing"}}};
    expectRefused(buffer.json.dump(), "error: /buffers/0/uri: 'missing': cannot read", "m.gltf");
}

TEST_F(GltfHostileFiles, OtherFilesAreRefused) {
    for (const char* bytes : {"", " ", "hello", "\x89PNG\r\n\x1a\n", "glT", "[]", "1", "null",
                              "\"glTF\"", "{}", "{\"asset\": 2}", "v 0 0 0\nf 1 1 1\n"}) {
        expectRefused(bytes, "m.gltf", "m.gltf");
        EXPECT_NE(messages.find("error: "), std::string::npos);
    }
    expectRefused("{}", "m.gltf: error: 'asset' is missing: this is no glTF", "m.gltf");
    expectRefused(std::string(1000, '\0'), "m.gltf:1:1: error: JSON: ", "m.gltf");
}

TEST_F(GltfHostileFiles, BombsCostLittle) {
    const long before = peakKib();
    expectRefused(R"({"asset":)" + std::string(1'000'000, '[') + std::string(1'000'000, ']') + "}",
                  "JSON: nested deeper than 256 levels", "m.gltf");
    std::string deepNodes = R"({"asset":{"version":"2.0"},"nodes":[)";
    for (int i = 1; i <= 2000; ++i) deepNodes += R"({"children":[)" + std::to_string(i) + "]},";
    expectRefused(deepNodes + "{}]}", "/nodes/1024: more than 1024 levels of nodes", "m.gltf");
    // Each node names the next one twice: 2^60 nodes if one were to follow.
    std::string shared = R"({"asset":{"version":"2.0"},"nodes":[)";
    for (int i = 1; i <= 60; ++i) {
        const std::string next = std::to_string(i);
        shared += R"({"children":[)" + next + ',' + next + "]},";
    }
    expectRefused(shared + "{}]}", "node 1 has another parent already: node 0", "m.gltf");

    // A few bytes that promise thousands of millions of elements.
    TestModel huge = square();
    huge.json["accessors"][0]["count"] = 4294967295u;
    expectRefused(huge.glb(), "/accessors/0: 4294967295 elements end at byte 51539607540");
    huge.json["accessors"][0].erase("bufferView");
    expectRefused(huge.glb(),
                  "/accessors/0: too many elements without a bufferView: 4294967295 here");

    // One accessor used again and again.
    TestModel repeated = square();
    repeated.add("accessors", {{"componentType", 5123}, {"type", "SCALAR"}, {"count", 999'999}});
    Json& primitives = repeated.json["meshes"][0]["primitives"];
    primitives[0]["indices"] = 2;
    for (int i = 0; i < 200; ++i) primitives.push_back(primitives[0]);
    repeated.json["accessors"][2]["count"] = 900'000;
    GltfLimits limits;
    limits.triangles = 1'000'000;
    write("repeated.glb", repeated.glb());
    EXPECT_FALSE(read(repeated.glb(), "repeated.glb", limits));
    EXPECT_NE(
        messages.find("/meshes/0/primitives/3: too many triangles: 300000 here, 900000 before, "
                      "at most 1000000 are read"),
        std::string::npos)
        << messages;
    EXPECT_NE(messages.find("too many errors; reading ends here"), std::string::npos);
    EXPECT_LT(peakKib() - before, 200 << 10);
}

TEST_F(GltfHostileFiles, EveryBudgetIsKept) {
    const auto refusal = [this](const TestModel& model, auto GltfLimits::*limit, int value) {
        GltfLimits limits;
        limits.*limit = value;
        EXPECT_FALSE(read(model.glb(), "m.glb", limits));
        return messages;
    };
    TestModel model = square();
    model.add("materials", Json::object());
    model.add("materials", Json::object());
    model.json["nodes"].push_back(Json::object());
    const auto times = model.addAccessor<float>({0, 1}, "SCALAR", 2);
    const auto values = model.addAccessor<float>({0, 0, 0, 1, 1, 1}, "VEC3", 2);
    model.json["animations"] = {
        {{"samplers", {{{"input", times}, {"output", values}}}},
         {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "scale"}}}}}}}};
    EXPECT_EQ(readGood(model).animations.size(), 1u);
    EXPECT_NE(refusal(model, &GltfLimits::bytes, 100).find("too large"), std::string::npos);
    EXPECT_NE(refusal(model, &GltfLimits::jsonBytes, 100).find("bytes of JSON are too many"),
              std::string::npos);
    EXPECT_NE(refusal(model, &GltfLimits::jsonValues, 30).find("more than 30 values"),
              std::string::npos);
    EXPECT_NE(refusal(model, &GltfLimits::jsonDepth, 3).find("nested deeper than 3"),
              std::string::npos);
    EXPECT_NE(refusal(model, &GltfLimits::vertices, 3).find("too many vertices: 4 here, 0 before"),
              std::string::npos);
    EXPECT_NE(refusal(model, &GltfLimits::triangles, 1).find("too many triangles"),
              std::string::npos);
    EXPECT_NE(refusal(model, &GltfLimits::nodes, 1).find("too many nodes"), std::string::npos);
    EXPECT_NE(refusal(model, &GltfLimits::materials, 1).find("too many materials"),
              std::string::npos);
    EXPECT_NE(refusal(model, &GltfLimits::animationNumbers, 9)
                  .find("too many numbers in animations: 10 here"),
              std::string::npos);

    TestModel files;
    std::ofstream(folder / "a.bin") << std::string(600, 'x');
    for (int i = 0; i < 2; ++i) files.add("buffers", {{"byteLength", 600}, {"uri", "a.bin"}});
    EXPECT_NE(refusal(files, &GltfLimits::bytes, 1000).find("/buffers/1/uri: 'a.bin': too large"),
              std::string::npos)
        << messages;
    files.json["buffers"][1]["uri"] = "data:;base64," + std::string(800, 'A');
    EXPECT_NE(refusal(files, &GltfLimits::bytes, 1800).find("the data: URI is too large"),
              std::string::npos)
        << messages;
}

}  // namespace
}  // namespace vitrine
