// SPDX-License-Identifier: MIT
#include "frame/check_snippets.hpp"

#include <set>

#include "frame/programs.hpp"

namespace vitrine {
namespace {

void check(const Context& context, const GeneratedShaders& shaders, Diagnostics& diagnostics) {
    try {
        ProgramSet programs(context.info(), Backend::kFragment, shaders, {});
        (void)programs.get("check_snippet");
    } catch (const InputError& error) {
        diagnostics.append(error.diagnostics());
    }
}

}  // namespace

Diagnostics checkSnippets(const Context& context, const Assets& assets) {
    Diagnostics diagnostics;
    std::set<const Snippet*> done;
    for (const auto& field : assets.fields)
        if (field != nullptr && done.insert(field.get()).second)
            check(context, generateShaders({field}, {}), diagnostics);
    for (const auto& material : assets.materials)
        if (material != nullptr && done.insert(material.get()).second)
            check(context, generateShaders({}, {material}), diagnostics);
    return diagnostics;
}

}  // namespace vitrine
