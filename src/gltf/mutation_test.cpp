// SPDX-License-Identifier: MIT
// Random damage: whatever comes out is a good model or a message, and nothing crashes. The seed in
// the trace repeats a failure.
#include <random>

#include "gltf/pose.hpp"
#include "gltf/test_model.hpp"

namespace vitrine {
namespace {

using Json = nlohmann::json;

class GltfMutations : public GltfTest {
  protected:
    /// Uses everything in a model as its reader would.
    static void expectUsable(const GltfModel& model) {
        const auto inRange = [](int index, size_t count) {
            return index >= kNoIndex && index < static_cast<int>(count);
        };
        for (const GltfTexture& t : model.textures)
            ASSERT_TRUE(inRange(t.image, model.images.size()));
        for (const GltfMaterial& m : model.materials)
            for (const GltfTextureInfo& t : {m.baseColorTexture, m.sheenColorTexture})
                ASSERT_TRUE(inRange(t.texture, model.textures.size()));
        for (const GltfMesh& mesh : model.meshes)
            for (const GltfPrimitive& p : mesh.primitives) {
                ASSERT_TRUE(inRange(p.material, model.materials.size()));
                ASSERT_FALSE(p.mesh.triangles.empty());
                for (const glm::uvec3& v : p.mesh.triangles)
                    ASSERT_LT(std::max({v.x, v.y, v.z}), p.mesh.positions.size());
                for (const glm::vec3& position : p.mesh.positions) ASSERT_TRUE(isFinite(position));
            }
        ASSERT_EQ(model.nodeOrder.size(), model.nodes.size());
        ASSERT_LT(static_cast<size_t>(model.scene), model.scenes.size());
        for (size_t a = 0; a < model.animations.size(); ++a)
            for (const float time : {-1.0f, 0.5f, 1e30f}) {
                const auto world = worldFromNodes(model, sampleAnimation(model, int(a), time));
                ASSERT_EQ(world.size(), model.nodes.size());
            }
        for (size_t s = 0; s < model.scenes.size(); ++s)
            for (const int node : nodesOfScene(model, int(s))) {
                ASSERT_TRUE(inRange(model.nodes[node].mesh, model.meshes.size()));
                ASSERT_TRUE(inRange(model.nodes[node].camera, model.cameras.size()));
                ASSERT_TRUE(inRange(model.nodes[node].light, model.lights.size()));
            }
        Diagnostics diagnostics;
        for (const GltfImage& image : model.images) decodeGltfImage(image, "m", diagnostics);
    }

    void tryReading(const std::string& bytes) {
        GltfLimits limits;  // small ones, for a test that is fast
        limits.emptyElements = limits.vertices = limits.triangles = 100'000;
        const auto model = read(bytes, "m.glb", limits);
        EXPECT_TRUE(model || messages.find("m.glb") != std::string::npos);
        ++(model ? accepted : refused);
        if (model) expectUsable(*model);
    }
    void TearDown() override {
        // Damage that always or never shows would test nothing.
        EXPECT_GT(accepted, 100);
        EXPECT_GT(refused, 100);
        GltfTest::TearDown();
    }

    int accepted = 0, refused = 0;
};

TEST_F(GltfMutations, OfBytes) {
    const std::string good = oneOfEach().glb();
    for (unsigned seed = 0; seed < 3000; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        std::string bytes = good;
        for (unsigned i = 0; i <= random() % 4; ++i)
            bytes[random() % bytes.size()] = static_cast<char>(random());
        tryReading(bytes);
        if (HasFailure()) break;
    }
}

/// Every value of a tree.
void collect(Json& json, std::vector<Json*>& to) {
    to.push_back(&json);
    if (json.is_structured())
        for (Json& child : json) collect(child, to);
}

TEST_F(GltfMutations, OfValues) {
    const TestModel good = oneOfEach();
    const Json odd =
        Json::parse(R"([0, 1, 2, 3, 4, -1, 0.5, 1e38, 1e300, -1e-45, 255, 65535, 4294967295,
        9007199254740991, 18446744073709551615, "", "VEC3", "STEP", "CUBICSPLINE", "MAT4", "../x", null, true,
        [], {}, [0], [1, 1], [0, 0, 0, 0], [[[]]], {"index": 0}, 5120, 5121, 5123, 5125, 5126, 12, 16])");
    for (unsigned seed = 0; seed < 3000; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        Json json = good.finished();
        for (unsigned i = 0; i <= random() % 3; ++i) {
            std::vector<Json*> values;
            collect(json, values);
            Json& value = *values[1 + random() % (values.size() - 1)];
            const Json& other = odd[random() % odd.size()];
            // Another type is refused at the first look, which is soon tested enough.
            if (value.is_number() == other.is_number() || random() % 8 == 0) value = other;
        }
        tryReading(
            glbOf(glbChunk("JSON", json.dump(), ' ') + glbChunk("BIN\0", good.binary, '\0')));
        if (HasFailure()) break;
    }
}

}  // namespace
}  // namespace vitrine
