// SPDX-License-Identifier: MIT
#include "image/compare.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <variant>

#include "app/cli/commands.hpp"
#include "base/file.hpp"
#include "image/decode.hpp"
#include "image/exr.hpp"
#include "image/heatmap.hpp"
#include "image/png.hpp"

namespace vitrine {
namespace {

constexpr uint64_t kMaxPictureBytes = 2ull << 30;

using Picture = std::variant<ImageRgba8, ImageRgba32f>;

Picture readPicture(const std::string& file) {
    const std::string text = readFile(file, kMaxPictureBytes);
    const std::span bytes(reinterpret_cast<const uint8_t*>(text.data()), text.size());
    if (imageFormat(bytes) == ImageFormat::kExr) return decodeExr(bytes, file);
    return decodeImage(bytes, file);
}

ImageSize sizeOf(const Picture& picture) {
    return std::visit(
        [](const auto& image) {
            return ImageSize{image.width, image.height};
        },
        picture);
}

ImageRgba8 asSrgb(Picture picture) {
    if (const auto* linear = std::get_if<ImageRgba32f>(&picture)) return srgbFromLinear(*linear);
    return std::get<ImageRgba8>(std::move(picture));
}

bool isLinear(const Picture& picture) {
    return std::holds_alternative<ImageRgba32f>(picture);
}

}  // namespace

int compare(const CompareOptions& options) {
    if (!options.output.empty()) checkWritable(options.output);
    Picture a = readPicture(options.a);
    Picture b = readPicture(options.b);
    const ImageSize sizeA = sizeOf(a), sizeB = sizeOf(b);
    if (sizeA != sizeB)
        throw InputError({options.b},
                         fmt::format("the picture is {}x{}; '{}' is {}x{}", sizeB.width,
                                     sizeB.height, options.a, sizeA.width, sizeA.height));
    // Two linear pictures by their light; one beside a PNG as it would look on a screen.
    const bool linear = isLinear(a) && isLinear(b);
    const int tolerance = static_cast<int>(options.tolerance.value_or(kDefaultTolerance));
    const Comparison c =
        linear ? compareLinear(std::get<ImageRgba32f>(a), std::get<ImageRgba32f>(b), tolerance)
               : compareImages(asSrgb(std::move(a)), asSrgb(std::move(b)), tolerance);
    const bool equal = !options.tolerance || c.fractionOver <= options.fraction;
    const nlohmann::ordered_json json{
        {"values", linear ? "linear" : "srgb"},
        {"rmse", c.rmse},
        {"psnr", std::isfinite(c.psnr) ? nlohmann::ordered_json(c.psnr) : nullptr},
        {"flip", c.flipMean},
        {"largest_difference", c.maxDifference},
        {"tolerance", tolerance},
        {"pixels", c.pixels},
        {"pixels_over", c.pixelsOver},
        {"fraction_over", c.fractionOver},
        {"pixels_not_finite", c.pixelsNotFinite},
        {"equal", equal}};
    if (!options.json.empty()) writeJson(options.json, json.dump(2));
    if (options.json != "-")
        fmt::print(
            "{}RMSE {:.5f}  PSNR {:.2f} dB  FLIP {:.5f}\n"
            "{} of {} pixels ({:.4f} %) differ by more than {}/255{}; the largest difference is "
            "{}\n",
            linear ? "linear light: " : "", c.rmse, c.psnr, c.flipMean, c.pixelsOver, c.pixels,
            100 * c.fractionOver, tolerance, linear ? " on a screen" : "",
            linear ? fmt::format("{:.5g}", c.maxDifference)
                   : fmt::format("{:.0f}/255", 255 * c.maxDifference));
    if (!options.output.empty())
        writeFileAtomically(options.output, encodePng(colorize(c.flipMap)));
    return equal ? 0 : 1;
}

}  // namespace vitrine
