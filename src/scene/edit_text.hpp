// SPDX-License-Identifier: MIT
// Writes changed values back into the text of a scene file: only the values that changed, and the
// lines that have to be added for them. Comments, order and layout stay.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace vitrine {

/// `text` with each `--set` assignment ("section.NAME.key=value") written into it. Parsing the
/// result gives what parsing `text` with these overrides gives; that is checked. Nothing is
/// written that is there already. What cannot be written (the object is in another file, the text
/// is not TOML) goes to `diagnostics`, and the rest is done.
std::string editSceneText(std::string_view text, const std::string& file,
                          const std::vector<std::string>& assignments, Diagnostics& diagnostics);

}  // namespace vitrine
