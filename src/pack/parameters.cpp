// SPDX-License-Identifier: MIT
#include "pack/parameters.hpp"

#include <fmt/format.h>

#include "base/text.hpp"

namespace vitrine {

std::vector<glm::vec4> parameterValues(const Snippet& snippet,
                                       const std::vector<ParameterValue>& set,
                                       Diagnostics& diagnostics) {
    std::vector<glm::vec4> values;
    std::vector<std::string> names;
    for (const Parameter& parameter : snippet.parameters) {
        values.push_back(parameter.defaultValue);
        names.push_back(parameter.name);
    }
    for (const ParameterValue& given : set) {
        size_t i = 0;
        while (i < names.size() && names[i] != given.name) ++i;
        if (i == names.size()) {
            diagnostics.error(given.where, fmt::format("{} has no parameter '{}'{}", snippet.file,
                                                       given.name, didYouMean(given.name, names)));
            continue;
        }
        const Parameter& parameter = snippet.parameters[i];
        const int wanted = componentCount(parameter.type);
        if (given.components != wanted) {
            diagnostics.error(
                given.where,
                fmt::format("{} is a {}; give {}", given.name, glslName(parameter.type),
                            wanted == 1 ? "one number" : fmt::format("{} numbers", wanted)));
            continue;
        }
        for (int c = 0; parameter.ranged && c < wanted; ++c) {
            if (given.value[c] >= parameter.minimum[c] && given.value[c] <= parameter.maximum[c])
                continue;
            diagnostics.error(given.where, fmt::format("{} is {}; it must be from {} to {}",
                                                       given.name, given.value[c],
                                                       parameter.minimum[c], parameter.maximum[c]));
            break;
        }
        values[i] = given.value;
    }
    return values;
}

int addParameters(const std::vector<glm::vec4>& values, std::vector<glm::vec4>& table) {
    const auto first = static_cast<int>(table.size());
    table.insert(table.end(), values.begin(), values.end());
    return first;
}

}  // namespace vitrine
