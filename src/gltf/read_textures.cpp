// SPDX-License-Identifier: MIT
#include "gltf/read_textures.hpp"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

#include "gltf/uri.hpp"
#include "image/decode.hpp"

namespace vitrine {
namespace {

std::span<const uint8_t> asBytes(const std::string& text) {
    return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

class TextureReader {
  public:
    TextureReader(ReadContext& context, const Buffers& buffers)
        : context_(context), buffers_(buffers) {}

    GltfImage readImage(const JsonValue& image, size_t number) {
        GltfImage result;
        result.name = nameOf(image, "image", number);
        if (!image.exists()) return result;
        if (image.has("uri") == image.has("bufferView")) {
            image.error("either 'uri' or 'bufferView' must be there, and not both");
            return result;
        }
        if (!readBytes(image, result)) return result;
        try {
            const ImageSize size = imageSize(asBytes(result.bytes), "");
            if (size.pixelCount() <= context_.left.pixels) {
                context_.left.pixels -= size.pixelCount();
                result.width = size.width;
                result.height = size.height;
                return result;
            }
            image.warning(
                fmt::format("too many pixels: {} here, {} in all; the picture is left out",
                            size.pixelCount(), context_.limits.pixels));
        } catch (const InputError& e) {
            warn(image, e);
        }
        result.bytes = {};
        return result;
    }

    /// `samplers` are textures without a picture.
    GltfTexture readTexture(const JsonValue& texture, const std::vector<GltfTexture>& samplers) {
        if (!texture.exists()) return {};
        const int sampler = texture.index("sampler", samplers.size());
        GltfTexture result = sampler != kNoIndex ? samplers[sampler] : GltfTexture{};
        result.image = texture.index("source", context_.model.images.size());
        if (!texture.has("source"))
            texture.warning("it has no picture in a format that is supported (PNG, JPEG)");
        return result;
    }

    static GltfTexture readSampler(const JsonValue& sampler) {
        GltfTexture result;
        result.wrapS = readWrap(sampler, "wrapS");
        result.wrapT = readWrap(sampler, "wrapT");
        // The numbers are OpenGL's.
        constexpr uint64_t kNearest = 9728, kLinear = 9729;
        const uint64_t mag = sampler.whole("magFilter", kLinear);
        if (mag != kNearest && mag != kLinear)
            sampler.error("magFilter", fmt::format("{} is no magnification filter", mag));
        if (mag == kNearest) result.magFilter = GltfFilter::kNearest;
        readMinFilter(sampler, result);
        return result;
    }

  private:
    /// False, with a message, if there are none.
    bool readBytes(const JsonValue& image, GltfImage& result) {
        if (image.has("bufferView")) {
            const BufferView* view = buffers_.findView(image);
            if (view == nullptr ||
                !context_.spend(&GltfLimits::bytes, view->bytes.size(), "bytes", image))
                return false;
            result.bytes = view->bytes;
            return true;
        }
        const std::string uri = image.text("uri");
        if (!isDataUri(uri) && !image.has("name")) result.name = uri;
        try {
            result.bytes = context_.loadUri(uri);
            return true;
        } catch (const std::invalid_argument& e) {
            image.error("uri", fmt::format("{}: {}", uriInQuotes(uri), e.what()));
        } catch (const InputError& e) {
            warn(image, e);
        }
        return false;
    }

    static void warn(const JsonValue& image, const InputError& error) {
        for (const Diagnostic& d : error.diagnostics().list())
            image.warning(d.message + "; a checkerboard takes the picture's place");
    }

    static GltfWrap readWrap(const JsonValue& sampler, std::string_view key) {
        constexpr uint64_t kRepeat = 10497, kClamp = 33071, kMirrored = 33648;
        switch (const uint64_t wrap = sampler.whole(key, kRepeat)) {
            case kRepeat:
                return GltfWrap::kRepeat;
            case kClamp:
                return GltfWrap::kClampToEdge;
            case kMirrored:
                return GltfWrap::kMirroredRepeat;
            default:
                sampler.error(key, fmt::format("{} is no way to wrap", wrap));
                return GltfWrap::kRepeat;
        }
    }

    static void readMinFilter(const JsonValue& sampler, GltfTexture& texture) {
        struct MinFilter {
            uint64_t number;
            GltfFilter filter;
            GltfMipmap mipmap;
        };
        using enum GltfMipmap;
        constexpr std::array<MinFilter, 6> kMinFilters{{
            {9728, GltfFilter::kNearest, kNone},
            {9729, GltfFilter::kLinear, kNone},
            {9984, GltfFilter::kNearest, kNearest},
            {9985, GltfFilter::kLinear, kNearest},
            {9986, GltfFilter::kNearest, kLinear},
            {9987, GltfFilter::kLinear, kLinear},
        }};
        const uint64_t number = sampler.whole("minFilter", kMinFilters.back().number);
        for (const MinFilter& known : kMinFilters) {
            if (known.number != number) continue;
            texture.minFilter = known.filter;
            texture.mipmap = known.mipmap;
            return;
        }
        sampler.error("minFilter", fmt::format("{} is no minification filter", number));
    }

    ReadContext& context_;
    const Buffers& buffers_;
};

}  // namespace

void readTextures(ReadContext& context, const Buffers& buffers) {
    TextureReader reader(context, buffers);
    const JsonValue images = context.root.array("images");
    for (size_t i = 0; i < images.size(); ++i)
        context.model.images.push_back(reader.readImage(images.objectAt(i), i));
    std::vector<GltfTexture> samplers;
    const JsonValue samplerValues = context.root.array("samplers");
    for (size_t i = 0; i < samplerValues.size(); ++i)
        samplers.push_back(TextureReader::readSampler(samplerValues.objectAt(i)));
    const JsonValue textures = context.root.array("textures");
    for (size_t i = 0; i < textures.size(); ++i)
        context.model.textures.push_back(reader.readTexture(textures.objectAt(i), samplers));
}

ImageRgba8 decodeGltfImage(const GltfImage& image, const std::string& file,
                           Diagnostics& diagnostics) {
    if (!image.bytes.empty()) {
        try {
            return decodeImage(asBytes(image.bytes), file);
        } catch (const InputError& e) {
            for (const Diagnostic& d : e.diagnostics().list())
                diagnostics.warning({file}, fmt::format("{}: {}; a checkerboard takes its place",
                                                        inQuotes(image.name), d.message));
        }
    }
    constexpr int kSide = 8;
    ImageRgba8 result(kSide, kSide);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const uint8_t value = (x + y) % 2 == 0 ? 255 : 0;
            const auto pixel = result.at(x, y);
            pixel[0] = pixel[2] = value;
            pixel[3] = 255;
        }
    return result;
}

}  // namespace vitrine
