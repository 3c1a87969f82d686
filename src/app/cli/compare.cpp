// SPDX-License-Identifier: MIT
#include "image/compare.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/cli/commands.hpp"
#include "base/file.hpp"
#include "image/heatmap.hpp"
#include "image/png.hpp"

namespace vitrine {
namespace {

constexpr uint64_t kMaxPictureBytes = 2ull << 30;

ImageRgba8 readPicture(const std::string& file) {
    const std::string bytes = readFile(file, kMaxPictureBytes);
    return decodePng({reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()}, file);
}

}  // namespace

int compare(const CompareOptions& options) {
    if (!options.output.empty()) checkWritable(options.output);
    const ImageRgba8 a = readPicture(options.a);
    const ImageRgba8 b = readPicture(options.b);
    if (a.width != b.width || a.height != b.height)
        throw InputError({options.b}, fmt::format("the picture is {}x{}; '{}' is {}x{}", b.width,
                                                  b.height, options.a, a.width, a.height));
    const int tolerance = static_cast<int>(options.tolerance.value_or(kDefaultTolerance));
    const Comparison c = compareImages(a, b, tolerance);
    const bool equal = !options.tolerance || c.fractionOver <= options.fraction;
    const nlohmann::ordered_json json{
        {"rmse", c.rmse},
        {"psnr", std::isfinite(c.psnr) ? nlohmann::ordered_json(c.psnr) : nullptr},
        {"flip", c.flipMean},
        {"largest_difference", c.maxDifference},
        {"tolerance", tolerance},
        {"pixels", c.pixels},
        {"pixels_over", c.pixelsOver},
        {"fraction_over", c.fractionOver},
        {"equal", equal}};
    if (!options.json.empty()) writeJson(options.json, json.dump(2));
    if (options.json != "-")
        fmt::print(
            "RMSE {:.5f}  PSNR {:.2f} dB  FLIP {:.5f}\n"
            "{} of {} pixels ({:.4f} %) differ by more than {}/255; the largest difference is "
            "{:.0f}/255\n",
            c.rmse, c.psnr, c.flipMean, c.pixelsOver, c.pixels, 100 * c.fractionOver, tolerance,
            255 * c.maxDifference);
    if (!options.output.empty())
        writeFileAtomically(options.output, encodePng(colorize(c.flipMap)));
    return equal ? 0 : 1;
}

}  // namespace vitrine
