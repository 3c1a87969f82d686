// SPDX-License-Identifier: MIT
#include "scene/values.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine {
namespace {

float linearFromSrgb(float c) {
    return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
}

bool readHexColor(const std::string& text, glm::vec3& rgb) {
    if (text.size() != 7 || text[0] != '#') return false;
    for (int i = 0; i < 3; ++i) {
        const std::string digits = text.substr(1 + 2 * static_cast<size_t>(i), 2);
        if (digits.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos) return false;
        rgb[i] = linearFromSrgb(static_cast<float>(std::stoi(digits, nullptr, 16)) / 255.0f);
    }
    return true;
}

bool inRange(double value, Range range) {
    return value >= range.minimum && value <= range.maximum;
}

/// What would have been right, for a value that is out of range. The limits of all numbers are
/// only worth a word to those who meet them.
std::string rangeText(Range range, double value) {
    const Range all;
    if (range.minimum > all.minimum && range.maximum < all.maximum)
        return fmt::format("from {} to {}", range.minimum, range.maximum);
    if (value < range.minimum) return fmt::format("at least {}", range.minimum);
    return fmt::format("at most {}", range.maximum);
}

}  // namespace

bool readNumber(const toml::node& node, const std::string& what, Range range, double& out,
                Diagnostics& diagnostics) {
    if (!node.is_number()) {
        diagnostics.error(placeOf(node), fmt::format("{} must be a number", what));
        return false;
    }
    const double value = *node.value<double>();
    if (!std::isfinite(value)) {
        diagnostics.error(placeOf(node), fmt::format("{} must be finite", what));
        return false;
    }
    if (!inRange(value, range)) {
        diagnostics.error(placeOf(node), fmt::format("{} is {}; it must be {}", what, value,
                                                     rangeText(range, value)));
        return false;
    }
    out = value;
    return true;
}

bool readVector(const toml::node& node, const std::string& what, Range range, glm::vec3& out,
                Diagnostics& diagnostics) {
    const toml::array* array = node.as_array();
    const auto isNumber = [](const toml::node& n) { return n.is_number(); };
    if (array == nullptr || array->size() != 3 ||
        !std::all_of(array->begin(), array->end(), isNumber)) {
        diagnostics.error(placeOf(node),
                          fmt::format("{} must be three numbers, as in [0, 1, 2]", what));
        return false;
    }
    glm::vec3 result;
    for (int i = 0; i < 3; ++i) {
        double value = 0;
        if (!readNumber(*array->get(static_cast<size_t>(i)), what, range, value, diagnostics))
            return false;
        result[i] = static_cast<float>(value);
    }
    out = result;
    return true;
}

bool readColor(const toml::node& node, const std::string& what, Range range, Color& out,
               Diagnostics& diagnostics) {
    if (const auto text = node.value_exact<std::string>()) {
        if (readHexColor(*text, out.rgb)) return true;
        diagnostics.error(placeOf(node), fmt::format("{} must be \"#rrggbb\" or [r, g, b]", what));
        return false;
    }
    if (node.is_array() && node.as_array()->size() == 3)
        return readVector(node, what, range, out.rgb, diagnostics);
    diagnostics.error(placeOf(node), fmt::format("{} must be \"#rrggbb\" or [r, g, b]", what));
    return false;
}

bool readText(const toml::node& node, const std::string& what, std::string& out,
              Diagnostics& diagnostics) {
    const auto text = node.value_exact<std::string>();
    if (!text) {
        diagnostics.error(placeOf(node), fmt::format("{} must be text in quotes", what));
        return false;
    }
    out = *text;
    return true;
}

void readParameters(const toml::node& node, const std::string& what,
                    std::vector<ParameterValue>& out, Diagnostics& diagnostics) {
    const toml::table* table = node.as_table();
    if (table == nullptr) {
        diagnostics.error(placeOf(node),
                          fmt::format("{} must be a table, as in {{ size = 0.5 }}", what));
        return;
    }
    for (const auto& [key, value] : *table) {
        ParameterValue parameter{std::string(key.str()), glm::vec4(0), 1, placeOf(value)};
        const std::string name = fmt::format("{}.{}", what, parameter.name);
        const toml::array* array = value.as_array();
        if (const auto flag = value.value_exact<bool>()) {
            parameter.value.x = *flag ? 1.0f : 0.0f;
        } else if (value.is_string()) {
            Color color;
            if (!readColor(value, name, {0, 1e9}, color, diagnostics)) continue;
            parameter.value = glm::vec4(color.rgb, 1);
            parameter.components = 3;
        } else if (array != nullptr && array->size() >= 2 && array->size() <= 4) {
            parameter.components = static_cast<int>(array->size());
            bool good = true;
            for (int i = 0; i < parameter.components; ++i) {
                double component = 0;
                good &= readNumber(*array->get(static_cast<size_t>(i)), name, {}, component,
                                   diagnostics);
                parameter.value[i] = static_cast<float>(component);
            }
            if (!good) continue;
        } else if (!value.is_number()) {
            diagnostics.error(placeOf(value),
                              fmt::format("{} must be a number, two to four of them in brackets, a "
                                          "colour, true or false",
                                          name));
            continue;
        } else {
            double number = 0;
            if (!readNumber(value, name, {}, number, diagnostics)) continue;
            parameter.value.x = static_cast<float>(number);
        }
        out.push_back(parameter);
    }
}

}  // namespace vitrine
