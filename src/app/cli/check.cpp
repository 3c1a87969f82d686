// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/cli/commands.hpp"

namespace vitrine {
namespace {

nlohmann::ordered_json toJson(const Diagnostics& diagnostics) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Diagnostic& d : diagnostics.list())
        list.push_back({{"severity", d.severity == Severity::kError ? "error" : "warning"},
                        {"file", d.where.file},
                        {"line", d.where.line},
                        {"column", d.where.column},
                        {"message", d.message}});
    return list;
}

}  // namespace

int check(const CheckOptions& options) {
    Diagnostics diagnostics;
    try {
        const LoadedScene loaded = loadAll(options.file, options.overrides, diagnostics);
        compileSnippets(loaded, diagnostics);
    } catch (const InputError& error) {
        diagnostics.append(error.diagnostics());
    }
    if (!options.json.empty())
        writeJson(options.json, toJson(diagnostics).dump(2));
    else if (!diagnostics.list().empty())
        fmt::print("{}\n", diagnostics.text());
    else
        fmt::print("{}: good\n", options.file);
    return diagnostics.hasErrors() ? 1 : 0;
}

}  // namespace vitrine
