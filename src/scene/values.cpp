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

bool readParameter(const toml::node& node, const std::string& what, ParameterValue& out,
                   Diagnostics& diagnostics) {
    out.where = placeOf(node);
    out.value = glm::vec4(0);
    out.components = 1;
    const toml::array* array = node.as_array();
    if (const auto flag = node.value_exact<bool>()) {
        out.value.x = *flag ? 1.0f : 0.0f;
        return true;
    }
    if (node.is_string()) {
        Color color;
        if (!readColor(node, what, {0, 1e9}, color, diagnostics)) return false;
        out.value = glm::vec4(color.rgb, 1);
        out.components = 3;
        return true;
    }
    if (array != nullptr && array->size() >= 2 && array->size() <= 4) {
        out.components = static_cast<int>(array->size());
        bool good = true;
        for (int i = 0; i < out.components; ++i) {
            double component = 0;
            good &=
                readNumber(*array->get(static_cast<size_t>(i)), what, {}, component, diagnostics);
            out.value[i] = static_cast<float>(component);
        }
        return good;
    }
    if (!node.is_number()) {
        diagnostics.error(out.where,
                          fmt::format("{} must be a number, two to four of them in brackets, a "
                                      "colour, true or false",
                                      what));
        return false;
    }
    double number = 0;
    if (!readNumber(node, what, {}, number, diagnostics)) return false;
    out.value.x = static_cast<float>(number);
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
        ParameterValue parameter;
        parameter.name = std::string(key.str());
        if (readParameter(value, fmt::format("{}.{}", what, parameter.name), parameter,
                          diagnostics))
            out.push_back(parameter);
    }
}

}  // namespace vitrine
