// SPDX-License-Identifier: MIT
#include "image/hdr.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "base/error.hpp"

namespace vitrine {
namespace {

constexpr std::array<std::string_view, 2> kSignatures{"#?RADIANCE", "#?RGBE"};
constexpr size_t kMaxHeaderBytes = 64u << 10;
/// Widths that the newer compression allows.
constexpr int kLeastRunWidth = 8, kMostRunWidth = 0x7fff;

using Rgbe = std::array<uint8_t, 4>;

struct Header {
    int width = 0, height = 0;
    bool bottomUp = false, rightToLeft = false;
    float exposure = 1;
};

class Reader {
  public:
    Reader(std::span<const uint8_t> bytes, std::string file)
        : bytes_(bytes), file_(std::move(file)) {}

    ImageRgba32f read() {
        readHeader();
        ImageRgba32f image(header_.width, header_.height);
        std::vector<Rgbe> row(static_cast<size_t>(header_.width));
        for (int y = 0; y < header_.height; ++y) {
            readRow(row);
            const std::span<float> out = image.row(header_.bottomUp ? header_.height - 1 - y : y);
            for (size_t x = 0; x < row.size(); ++x)
                store(row[x], &out[4 * (header_.rightToLeft ? row.size() - 1 - x : x)]);
        }
        return image;
    }

  private:
    [[noreturn]] void fail(const std::string& message) const {
        throw InputError({file_},
                         fmt::format("the Radiance picture {} (at byte {})", message, at_));
    }

    std::string_view line() {
        const size_t limit = std::min(bytes_.size(), kMaxHeaderBytes);
        const size_t begin = at_;
        while (at_ < limit && bytes_[at_] != '\n') ++at_;
        if (at_ == limit)
            fail(at_ == bytes_.size() ? "ends within its header" : "has a header without an end");
        std::string_view text(reinterpret_cast<const char*>(bytes_.data()) + begin, at_ - begin);
        ++at_;
        if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
        return text;
    }

    void readHeader() {
        if (!isHdr(bytes_)) fail("has no header");
        for (std::string_view text = line(); !text.empty(); text = line()) {
            if (text.starts_with("FORMAT=") && text != "FORMAT=32-bit_rle_rgbe")
                fail("holds XYZ colours or something newer, not RGB");
            if (text.starts_with("EXPOSURE=")) multiplyExposure(text.substr(9));
        }
        readSize(line());
    }

    void multiplyExposure(std::string_view text) {
        text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
        float value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        // Many such lines multiply.
        header_.exposure *= value;
        if (error != std::errc{} || !(header_.exposure > 1e-20f && header_.exposure < 1e20f))
            fail("has an exposure that is no positive number");
    }

    /// "-Y 512 +X 1024": rows from the top, pixels from the left.
    void readSize(std::string_view text) {
        const std::string_view whole = text;
        const auto axis = [&](char name, bool& minus) -> std::optional<int> {
            text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
            if (text.size() < 4 || (text[0] != '-' && text[0] != '+') || text[1] != name) return {};
            minus = text[0] == '-';
            text.remove_prefix(std::min(text.find_first_not_of(' ', 2), text.size()));
            int value = 0;
            const auto [end, error] =
                std::from_chars(text.data(), text.data() + text.size(), value);
            if (error != std::errc{} || value <= 0) return {};
            text.remove_prefix(static_cast<size_t>(end - text.data()));
            return value;
        };
        bool fromTop = false;
        const auto height = axis('Y', fromTop);
        const auto width = axis('X', header_.rightToLeft);
        if (!height || !width || !text.empty())
            fail(fmt::format("has the size '{}'; one such as '-Y 512 +X 1024' is needed",
                             whole.substr(0, 40)));
        header_.bottomUp = !fromTop;
        header_.width = *width;
        header_.height = *height;
        if (std::max(*width, *height) > kMaxImageSide ||
            ImageSize{*width, *height}.pixelCount() > kMaxHdrPixels)
            fail(fmt::format("is {} x {}; at most {} pixels a side and {} in all are read", *width,
                             *height, kMaxImageSide, kMaxHdrPixels));
        // A row takes a pixel and a run, at the least.
        if ((bytes_.size() - at_) / 4 < static_cast<size_t>(*height))
            fail(fmt::format("is too short for {} x {} pixels", *width, *height));
    }

    uint8_t byte() {
        if (at_ >= bytes_.size()) fail("is cut short");
        return bytes_[at_++];
    }
    Rgbe pixel() {
        Rgbe p{};
        for (uint8_t& component : p) component = byte();
        return p;
    }

    void readRow(std::vector<Rgbe>& row) {
        const int width = header_.width;
        const bool newer = width >= kLeastRunWidth && width <= kMostRunWidth &&
                           bytes_.size() - at_ >= 4 && bytes_[at_] == 2 && bytes_[at_ + 1] == 2 &&
                           bytes_[at_ + 2] < 128;
        newer ? readNewRow(row) : readOldRow(row);
    }

    /// The components one after the other, each in runs and literal stretches.
    void readNewRow(std::vector<Rgbe>& row) {
        const int width = bytes_[at_ + 2] << 8 | bytes_[at_ + 3];
        if (width != header_.width) fail("has a row of another width");
        at_ += 4;
        for (size_t component = 0; component < 4; ++component)
            for (size_t x = 0; x < row.size();) {
                const uint8_t code = byte();
                const bool run = code > 128;
                const size_t count = run ? code - 128u : code;
                if (count == 0 || count > row.size() - x) fail("has a run beyond its row");
                const uint8_t repeated = run ? byte() : uint8_t{0};
                for (size_t i = 0; i < count; ++i) row[x++][component] = run ? repeated : byte();
            }
    }

    /// Pixels; one of (1, 1, 1, n) repeats the one before n times, and runs in succession make the
    /// digits of a larger n.
    void readOldRow(std::vector<Rgbe>& row) {
        int shift = 0;
        for (size_t x = 0; x < row.size();) {
            const Rgbe p = pixel();
            if (p[0] != 1 || p[1] != 1 || p[2] != 1) {
                row[x++] = p;
                shift = 0;
                continue;
            }
            if (shift > 16 || x == 0) fail("has a run of nothing");
            const size_t count = static_cast<size_t>(p[3]) << shift;
            if (count > row.size() - x) fail("has a run beyond its row");
            std::fill_n(row.begin() + static_cast<std::ptrdiff_t>(x), count, row[x - 1]);
            x += count;
            shift += 8;
        }
    }

    void store(const Rgbe& p, float* out) const {
        // No light is that bright; the limit keeps what follows finite.
        const float unit =
            p[3] == 0 ? 0.0f : std::min(std::ldexp(1 / header_.exposure, p[3] - 136), 1e28f);
        for (size_t i = 0; i < 3; ++i) out[i] = static_cast<float>(p[i]) * unit;
        out[3] = 1;
    }

    std::span<const uint8_t> bytes_;
    std::string file_;
    size_t at_ = 0;
    Header header_;
};

}  // namespace

bool isHdr(std::span<const uint8_t> bytes) {
    return std::any_of(kSignatures.begin(), kSignatures.end(), [&](std::string_view s) {
        return bytes.size() >= s.size() && std::equal(s.begin(), s.end(), bytes.begin());
    });
}

ImageRgba32f decodeHdr(std::span<const uint8_t> bytes, const std::string& file) {
    return Reader(bytes, file).read();
}

}  // namespace vitrine
