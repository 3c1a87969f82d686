// SPDX-License-Identifier: MIT
#include "app/cli/field_slice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "image/lettering.hpp"

namespace vitrine {
namespace {

constexpr int kLongSide = 900;
constexpr int kLegendHeight = 112;
constexpr float kMargin = 0.12f;  // around the bounds
/// A picture is at most this many times as wide as high, or it would be a line.
constexpr float kLargestAspect = 2.2f;
constexpr float kLinesAcross = 14;
constexpr const char* kAxes = "xyz";

const glm::vec3 kPaper(0.985f, 0.98f, 0.97f);
const glm::vec3 kInside(0.13f, 0.35f, 0.60f);
const glm::vec3 kOutside(0.85f, 0.50f, 0.13f);
const glm::vec3 kInk(0.10f, 0.10f, 0.12f);
const glm::vec3 kWrong(0.82f, 0.05f, 0.10f);
const glm::vec3 kBad(1.0f, 0.0f, 1.0f);
const glm::vec3 kFrame(0.45f, 0.45f, 0.47f);

/// 1, 2 or 5 times a power of ten, at least `value`.
float niceStep(float value) {
    const float power = std::pow(10.0f, std::floor(std::log10(value)));
    for (const float factor : {1.0f, 2.0f, 5.0f})
        if (factor * power >= value * 0.999f) return factor * power;
    return 10 * power;
}

/// Cover of a line of `width` pixels at `away` pixels from its middle.
float cover(float away, float width) {
    return std::clamp(0.5f * width + 0.5f - std::abs(away), 0.0f, 1.0f);
}

struct View {
    int right = 0, up = 1, across = 2;  // axes of the object
    float depth = 0;                    // along `across`
    glm::vec2 low{0}, size{1};
    int width = 0, height = 0;
    float pixel = 1;  // object space

    [[nodiscard]] glm::vec3 point(int x, int y) const {
        glm::vec3 p(0);
        p[across] = depth;
        p[right] = low.x + (static_cast<float>(x) + 0.5f) * pixel;
        p[up] = low.y + (static_cast<float>(height - 1 - y) + 0.5f) * pixel;
        return p;
    }
    [[nodiscard]] glm::vec2 onPaper(const glm::vec3& p) const {
        return {(p[right] - low.x) / pixel, static_cast<float>(height) - (p[up] - low.y) / pixel};
    }
};

View chooseView(const FieldReport& report, bool steep, const glm::vec3& gradient) {
    View v;
    if (steep) {
        // Ties go to z, as people draw.
        for (const int axis : {1, 0})
            if (std::abs(gradient[axis]) < 0.8f * std::abs(gradient[v.across])) v.across = axis;
    }
    v.right = v.across == 0 ? 2 : 0;
    v.up = v.across == 1 ? 2 : 1;
    v.depth = steep ? report.steepest.point[v.across] : report.bounds.centre()[v.across];
    const glm::vec3 extent = report.bounds.extent();
    const float margin = kMargin * std::max(extent[v.right], extent[v.up]);
    glm::vec2 size(extent[v.right] + 2 * margin, extent[v.up] + 2 * margin);
    size.x = std::max(size.x, size.y / kLargestAspect);
    size.y = std::max(size.y, size.x / kLargestAspect);
    v.pixel = std::max(size.x, size.y) / static_cast<float>(kLongSide);
    v.width = std::max(static_cast<int>(size.x / v.pixel), 1);
    v.height = std::max(static_cast<int>(size.y / v.pixel), 1);
    v.size = glm::vec2(v.width, v.height) * v.pixel;
    const glm::vec3 centre = report.bounds.centre();
    v.low = glm::vec2(centre[v.right], centre[v.up]) - 0.5f * v.size;
    return v;
}

class SlicePainter {
  public:
    SlicePainter(const FieldReport& report, const Snippet& snippet, const FieldEvaluator& evaluate)
        : report_(report), snippet_(snippet) {
        steep_ =
            report.steepest.value > kCleanSlope * std::max(snippet.lipschitz.value_or(1), 1.0f);
        place_ = report.steepest;
        if (!steep_) {
            place_.time = 0;
            place_.setting.clear();
            for (const Parameter& p : snippet.parameters) place_.setting.push_back(p.defaultValue);
        }
        const glm::vec3 extent = report.bounds.extent();
        FieldSamples one;
        one.add({place_.point, place_.time, 1e-3f * glm::length(extent)}, place_.setting);
        view_ = chooseView(report, steep_, evaluate(one)[0].gradient);
        image_ = ImageRgba8(view_.width, view_.height + kLegendHeight);
        lineStep_ = niceStep(std::max(view_.size.x, view_.size.y) / kLinesAcross);
        for (int y = 0; y < view_.height; ++y) paintRow(y, evaluate);
    }

    ImageRgba8 finish() {
        drawBounds();
        if (steep_) drawCross();
        drawLegend();
        return std::move(image_);
    }

  private:
    void set(int x, int y, const glm::vec3& color) {
        const auto pixel = image_.at(x, y);
        for (size_t c = 0; c < 3; ++c)
            pixel[c] = static_cast<uint8_t>(
                std::clamp(color[static_cast<int>(c)], 0.0f, 1.0f) * 255 + 0.5f);
        pixel[3] = 255;
    }

    void blend(int x, int y, const glm::vec3& color, float alpha) {
        if (x < 0 || y < 0 || x >= image_.width || y >= image_.height || alpha <= 0) return;
        const auto pixel = image_.at(x, y);
        set(x, y, glm::mix(glm::vec3(pixel[0], pixel[1], pixel[2]) / 255.0f, color, alpha));
    }

    void paintRow(int y, const FieldEvaluator& evaluate) {
        FieldSamples row;
        for (int x = 0; x < view_.width; ++x)
            row.add({view_.point(x, y), place_.time, 1.2f * view_.pixel}, place_.setting);
        const std::vector<FieldValue> values = evaluate(row);
        for (int x = 0; x < view_.width; ++x)
            set(x, y, colorOf(values[static_cast<size_t>(x)], x, y));
    }

    [[nodiscard]] glm::vec3 colorOf(const FieldValue& v, int x, int y) const {
        if (v.bad > 0) return kBad;
        glm::vec3 flat = v.gradient;
        flat[view_.across] = 0;
        // Pixels to a line: by the field's own slope in the plane.
        const float perPixel = std::max(glm::length(flat), 1e-6f) * view_.pixel;
        glm::vec3 color = background(v.distance);
        const float nearest = std::round(v.distance / lineStep_) * lineStep_;
        if (std::abs(nearest) > 0.5f * lineStep_)
            color = glm::mix(color, kInk, 0.38f * cover((v.distance - nearest) / perPixel, 0.8f));
        if (v.slope > kCleanSlope) {
            const float stripe = static_cast<float>((x + y) % 9) - 4;
            color = glm::mix(color, kWrong, 0.10f + 0.75f * cover(stripe, 1.4f));
        }
        return glm::mix(color, kInk, cover(v.distance / perPixel, 3.0f));
    }

    [[nodiscard]] glm::vec3 background(float distance) const {
        const float far = std::abs(distance) / (0.5f * kLinesAcross * lineStep_);
        const float strength = 0.10f + 0.62f * (1 - std::exp(-2.2f * far));
        return glm::mix(kPaper, distance < 0 ? kInside : kOutside, strength);
    }

    /// Dashed, over the picture.
    void drawBounds() {
        const glm::vec2 a = view_.onPaper(report_.bounds.min),
                        b = view_.onPaper(report_.bounds.max);
        const auto dash = [](int i) { return i / 7 % 2 == 0 ? 0.9f : 0.0f; };
        for (int x = static_cast<int>(a.x); x <= static_cast<int>(b.x); ++x)
            for (const float y : {a.y, b.y}) blendInView(x, static_cast<int>(y), dash(x));
        for (int y = static_cast<int>(b.y); y <= static_cast<int>(a.y); ++y)
            for (const float x : {a.x, b.x}) blendInView(static_cast<int>(x), y, dash(y));
    }
    void blendInView(int x, int y, float alpha) {
        if (y < view_.height) blend(x, y, kFrame, alpha);
    }

    void drawCross() {
        const glm::vec2 c = view_.onPaper(place_.point);
        for (int y = -16; y <= 16; ++y)
            for (int x = -16; x <= 16; ++x) {
                const float r = std::hypot(static_cast<float>(x), static_cast<float>(y));
                const int px = static_cast<int>(c.x) + x, py = static_cast<int>(c.y) + y;
                if (py >= view_.height) continue;
                blend(px, py, glm::vec3(1), cover(r - 11, 5));
                blend(px, py, kWrong, cover(r - 11, 2.5f));
            }
    }

    void drawLegend() {
        const int top = view_.height;
        for (int y = top; y < image_.height; ++y)
            for (int x = 0; x < image_.width; ++x) set(x, y, y == top ? kFrame : glm::vec3(1));
        drawScale(top + 14);
        int x = 14 + drawSign(14, top + 44, "surface", [](int, int dy) {
                    return glm::vec4(kInk, cover(static_cast<float>(dy) - 6.5f, 3));
                });
        if (steep_ || report_.steepShare > 0)
            x += drawSign(x, top + 44, "slope above 1", [](int dx, int dy) {
                const float stripe = static_cast<float>((dx + dy) % 9) - 4;
                return glm::vec4(kWrong, 0.10f + 0.75f * cover(stripe, 1.4f));
            });
        x += drawSign(x, top + 44, "bounds", [](int dx, int dy) {
            return glm::vec4(kFrame, dy == 6 && dx / 7 % 2 == 0 ? 0.9f : 0.0f);
        });
        if (report_.notFinite > 0)
            drawSign(x, top + 44, "no number", [](int, int) { return glm::vec4(kBad, 1); });
        drawTitle(top + 70);
    }

    /// Two lines, broken at a space; what is longer than both is left out.
    void drawTitle(int top) {
        const std::string file = snippet_.file.substr(snippet_.file.rfind('/') + 1);
        std::string text = fmt::format("{}  at {} = {:.3g},  slope {:.3g}", file,
                                       kAxes[view_.across], view_.depth, report_.steepest.value);
        if (steep_) text += " at " + describePlace(place_, snippet_);
        const auto room = static_cast<size_t>((image_.width - 28) / (kLetterWidth * kTextScale));
        for (int line = 0; line < 2 && !text.empty(); ++line) {
            size_t end = text.size() <= room ? text.size() : text.rfind(' ', room);
            if (end == std::string::npos || end == 0) end = std::min(room, text.size());
            write(14, top + 20 * line, text.substr(0, end));
            text.erase(0, std::min(end + 1, text.size()));
        }
    }

    /// Colours from far inside to far outside, with numbers at some lines.
    void drawScale(int top) {
        const int left = 14, width = image_.width - 28;
        const float reach = 6 * lineStep_;
        for (int x = 0; x < width; ++x) {
            const float d =
                reach * (2 * (static_cast<float>(x) + 0.5f) / static_cast<float>(width) - 1);
            for (int y = 0; y < 9; ++y) set(left + x, top + y, background(d));
        }
        for (int line = -6; line <= 6; ++line) {
            const int x = left + (line + 6) * (width - 1) / 12;
            for (int y = line == 0 ? -3 : 0; y < (line == 0 ? 12 : 9); ++y)
                blend(x, top + y, kInk, line == 0 ? 1 : 0.4f);
            if (line % 2 != 0 || std::abs(line) == 6) continue;
            const std::string text = fmt::format("{:.3g}", static_cast<float>(line) * lineStep_);
            write(x - textWidth(text, 1) / 2, top + 13, text, 1);
        }
    }

    template <class Sign>
    int drawSign(int left, int top, const std::string& text, Sign sign) {
        for (int y = 0; y < 14; ++y)
            for (int x = 0; x < 28; ++x) {
                const glm::vec4 c = sign(x, y);
                blend(left + x, top + y, glm::vec3(c.x, c.y, c.z), c.w);
            }
        write(left + 36, top, text);
        return 36 + textWidth(text, kTextScale) + 24;
    }

    void write(int x, int y, const std::string& text, int scale = kTextScale) {
        writeText(image_, x, y, scale, glm::u8vec3(kInk * 255.0f), text);
    }

    static constexpr int kTextScale = 2;
    const FieldReport& report_;
    const Snippet& snippet_;
    bool steep_ = false;
    FieldPlace place_;
    View view_;
    ImageRgba8 image_;
    float lineStep_ = 1;
};

}  // namespace

ImageRgba8 drawFieldSlice(const FieldReport& report, const Snippet& snippet,
                          const FieldEvaluator& evaluate) {
    return SlicePainter(report, snippet, evaluate).finish();
}

}  // namespace vitrine
