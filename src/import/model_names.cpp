// SPDX-License-Identifier: MIT
#include "import/model_names.hpp"

namespace vitrine {

std::string UniqueNames::make(const std::string& wanted) {
    if (taken_.insert(wanted).second) return wanted;
    // The number is remembered, or a thousand equal names would take a million tries.
    size_t& number = last_.try_emplace(wanted, 1).first->second;
    while (true) {
        std::string name = wanted + '#' + std::to_string(++number);
        if (taken_.insert(name).second) return name;
    }
}

}  // namespace vitrine
