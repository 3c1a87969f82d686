// SPDX-License-Identifier: MIT
// What annotations mean. Each message says the whole form, so that nobody has to look it up.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "base/text.hpp"
#include "sdf/annotation.hpp"
#include "sdf/limits.hpp"

namespace vitrine::glsl {

namespace {

const std::vector<std::string> kNames = {"slider",    "color", "checkbox", "bounds",
                                         "lipschitz", "parts", "group"};

constexpr std::string_view kSliderForm = "slider[min, default, max]";
constexpr std::string_view kColorForm = "color[red, green, blue]";
constexpr std::string_view kCheckboxForm = "checkbox[true] or checkbox[false]";
constexpr std::string_view kBoundsForm = "bounds[minX, minY, minZ, maxX, maxY, maxZ]";
constexpr std::string_view kLipschitzForm = "lipschitz[1.4]";
constexpr std::string_view kPartsForm = "parts[body, eyes]";

std::string expected(std::string_view form) {
    return "; expected " + std::string(form);
}

/// A finite number written as in GLSL or C; tells what is wrong with anything else.
std::optional<float> number(std::string_view word, Place place, std::string_view form,
                            Problems& problems) {
    const auto fail = [&](const char* what) {
        problems.error(place, "'" + std::string(word) + "' is " + what + expected(form));
        return std::nullopt;
    };
    if (word.empty()) {
        problems.error(place, "a number is missing" + expected(form));
        return {};
    }
    std::string_view digits = word;
    if (digits[0] == '+') digits.remove_prefix(1);
    // from_chars also takes "nan" and "infinity".
    const size_t sign = !digits.empty() && digits[0] == '-' ? 1 : 0;
    if (digits.size() == sign ||
        (digits[sign] != '.' && (digits[sign] < '0' || digits[sign] > '9')))
        return fail("not a number");
    double value = 0.0;
    auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const char* last = digits.data() + digits.size();
    if (end != last && end + 1 == last && (*end == 'f' || *end == 'F')) ++end;
    if (end != last || error == std::errc::invalid_argument) return fail("not a number");
    if (error == std::errc::result_out_of_range || !std::isfinite(static_cast<float>(value)))
        return fail("too large or too small");
    return static_cast<float>(value);
}

/// All values as plain numbers, or nothing after an error.
std::optional<std::vector<float>> numbers(const Annotation& annotation, size_t count,
                                          std::string_view form, Problems& problems) {
    if (annotation.values.size() != count) {
        problems.error(annotation.place,
                       annotation.name + " has " + std::to_string(annotation.values.size()) +
                           (annotation.values.size() == 1 ? " value" : " values") + expected(form));
        return {};
    }
    std::vector<float> result;
    for (const AnnotationValue& value : annotation.values) {
        if (value.inParentheses) {
            problems.error(value.place, "no parentheses here" + expected(form));
            return {};
        }
        const auto one = number(value.words[0], value.place, form, problems);
        if (!one) return {};
        result.push_back(*one);
    }
    return result;
}

void applySlider(const Annotation& annotation, Parameter& parameter, Problems& problems) {
    const int size = componentCount(parameter.type);
    std::string form(kSliderForm);
    if (size == 2) form = "slider[(minX,minY), (defaultX,defaultY), (maxX,maxY)]";
    if (size == 3) form = "slider[(min,min,min), (default,default,default), (max,max,max)]";
    if (size == 4) form = "slider[(min,...4), (default,...4), (max,...4)]";
    if (annotation.values.size() != 3) {
        problems.error(annotation.place,
                       "slider has " + std::to_string(annotation.values.size()) +
                           (annotation.values.size() == 1 ? " value" : " values") + expected(form));
        return;
    }
    std::array<glm::vec4, 3> range{};
    for (size_t i = 0; i < 3; ++i) {
        const AnnotationValue& value = annotation.values[i];
        // One number for all components, or one each.
        const bool single = !value.inParentheses;
        if (!single && static_cast<int>(value.words.size()) != size) {
            problems.error(value.place, "a " + std::string(glslName(parameter.type)) + " takes " +
                                            std::to_string(size) + " numbers, not " +
                                            std::to_string(value.words.size()) + expected(form));
            return;
        }
        for (int c = 0; c < size; ++c) {
            const auto one = number(value.words[single ? 0 : c], value.place, form, problems);
            if (!one) return;
            if (parameter.type == ParameterType::kInt &&
                (*one != std::floor(*one) || std::abs(*one) > 16'777'216.0f)) {
                problems.error(value.place, "'" + value.words[0] +
                                                "' is not a whole number below 2^24, and '" +
                                                parameter.name + "' is an int");
                return;
            }
            range[i][c] = *one;
        }
    }
    for (int c = 0; c < size; ++c) {
        if (range[0][c] > range[2][c]) {
            problems.error(annotation.values[0].place,
                           "the minimum is above the maximum; the order is min, DEFAULT, max");
            return;
        }
        if (range[1][c] < range[0][c] || range[1][c] > range[2][c]) {
            problems.error(annotation.values[1].place,
                           "the default is outside of the range; the order is min, DEFAULT, max");
            return;
        }
    }
    parameter.minimum = range[0];
    parameter.defaultValue = range[1];
    parameter.maximum = range[2];
    parameter.ranged = true;
}

void applyColor(const Annotation& annotation, Parameter& parameter, Problems& problems) {
    const auto values = numbers(annotation, 3, kColorForm, problems);
    if (!values) return;
    parameter.type = ParameterType::kColor;
    for (int c = 0; c < 3; ++c) {
        const float value = (*values)[static_cast<size_t>(c)];
        if (value < 0.0f || value > 1.0f) {
            problems.error(annotation.values[static_cast<size_t>(c)].place,
                           "a colour lies between 0 and 1" + expected(kColorForm));
            return;
        }
        parameter.defaultValue[c] = value;
    }
    parameter.minimum = glm::vec4(0.0f);
    parameter.maximum = glm::vec4(1.0f);
    parameter.ranged = true;
}

void applyCheckbox(const Annotation& annotation, Parameter& parameter, Problems& problems) {
    const std::string& word = annotation.values[0].words[0];
    const bool on = word == "true" || word == "1";
    if (annotation.values.size() != 1 || (!on && word != "false" && word != "0")) {
        problems.error(annotation.place, "checkbox is on or off" + expected(kCheckboxForm));
        return;
    }
    parameter.defaultValue.x = on ? 1.0f : 0.0f;
    parameter.ranged = true;
}

void applyBounds(const Annotation& annotation, Snippet& snippet, Problems& problems) {
    const auto values = numbers(annotation, 6, kBoundsForm, problems);
    if (!values) return;
    Aabb box;
    for (int c = 0; c < 3; ++c) {
        box.min[c] = (*values)[static_cast<size_t>(c)];
        box.max[c] = (*values)[static_cast<size_t>(c) + 3];
        if (!(box.min[c] < box.max[c])) {
            problems.error(annotation.values[static_cast<size_t>(c)].place,
                           "the minimum is not below the maximum" + expected(kBoundsForm));
            return;
        }
    }
    if (snippet.bounds) problems.error(annotation.place, "the bounds are given twice");
    snippet.bounds = box;
}

void applyLipschitz(const Annotation& annotation, Snippet& snippet, Problems& problems) {
    const auto values = numbers(annotation, 1, kLipschitzForm, problems);
    if (!values) return;
    // A thousand: beyond it a step is below a thousandth of the distance, and nothing is ever hit.
    if (!((*values)[0] > 0.0f && (*values)[0] <= 1000.0f)) {
        problems.error(annotation.values[0].place,
                       "the largest slope of the field lies above 0 and up to 1000" +
                           expected(kLipschitzForm));
        return;
    }
    if (snippet.lipschitz) problems.error(annotation.place, "lipschitz is given twice");
    snippet.lipschitz = (*values)[0];
}

void applyParts(const Annotation& annotation, Snippet& snippet, Problems& problems) {
    if (!snippet.partNames.empty()) problems.error(annotation.place, "the parts are given twice");
    for (const AnnotationValue& value : annotation.values) {
        const std::string& name = value.words[0];
        const bool plain = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                   c == '_' || c == '-';
        });
        if (value.inParentheses || !plain) {
            problems.error(value.place, "the name of a part has letters, digits, _ and -" +
                                            expected(kPartsForm));
            return;
        }
        if (std::count(snippet.partNames.begin(), snippet.partNames.end(), name) > 0) {
            problems.error(value.place, "two parts are called '" + name + "'");
            return;
        }
        snippet.partNames.push_back(name);
    }
}

bool checkClosed(const Annotation& annotation, std::string_view form, Problems& problems) {
    if (!annotation.closed)
        problems.error(annotation.place, annotation.name + " has no closing ']'" + expected(form));
    return annotation.closed;
}

}  // namespace

bool isControl(std::string_view name) {
    return name == "slider" || name == "color" || name == "checkbox";
}

std::string annotationSuggestion(std::string_view name) {
    return didYouMean(name, kNames);
}

void applyControl(const Annotation& annotation, Parameter& parameter, Problems& problems) {
    struct Control {
        std::string_view name, form, types;
        bool fits;
        void (*apply)(const Annotation&, Parameter&, Problems&);
    };
    const ParameterType type = parameter.type;
    const bool isBool = type == ParameterType::kBool;
    const bool isVec3 = type == ParameterType::kVec3 || type == ParameterType::kColor;
    const std::array<Control, 3> controls = {{
        {"slider", kSliderForm, "float, int, vec2, vec3 or vec4", !isBool, applySlider},
        {"color", kColorForm, "vec3", isVec3, applyColor},
        {"checkbox", kCheckboxForm, "bool", isBool, applyCheckbox},
    }};
    for (const Control& control : controls) {
        if (control.name != annotation.name) continue;
        if (!checkClosed(annotation, control.form, problems)) return;
        if (!control.fits) {
            problems.error(annotation.place, std::string(control.name) + " is for " +
                                                 std::string(control.types) + ", and '" +
                                                 parameter.name + "' is a " +
                                                 std::string(glslName(type)));
            return;
        }
        control.apply(annotation, parameter, problems);
        if (!annotation.label.empty()) parameter.label = annotation.label;
    }
}

bool applyToSnippet(const Annotation& annotation, Snippet& snippet, Problems& problems) {
    struct Note {
        std::string_view name, form;
        void (*apply)(const Annotation&, Snippet&, Problems&);
    };
    constexpr std::array<Note, 3> kNotes = {{
        {"bounds", kBoundsForm, applyBounds},
        {"lipschitz", kLipschitzForm, applyLipschitz},
        {"parts", kPartsForm, applyParts},
    }};
    for (const Note& note : kNotes) {
        if (note.name != annotation.name) continue;
        if (snippet.kind != SnippetKind::kField)
            problems.warning(annotation.place,
                             annotation.name + " means something only in a field");
        else if (checkClosed(annotation, note.form, problems))
            note.apply(annotation, snippet, problems);
        return true;
    }
    return false;
}

}  // namespace vitrine::glsl
