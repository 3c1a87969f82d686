// SPDX-License-Identifier: MIT
// Names for what comes out of models, where names may be missing and the same twice.
#pragma once

#include <string>
#include <unordered_map>
#include <unordered_set>

namespace vitrine {

class UniqueNames {
  public:
    /// Says that a name is taken; "" never is.
    void take(const std::string& name) {
        if (!name.empty()) taken_.insert(name);
    }
    /// `wanted`, or `wanted#2` and so on if that is taken; takes it.
    std::string make(const std::string& wanted);

  private:
    std::unordered_set<std::string> taken_;
    std::unordered_map<std::string, size_t> last_;  ///< number by wanted name
};

}  // namespace vitrine
