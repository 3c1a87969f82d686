// SPDX-License-Identifier: MIT
#include "app/viewer/load.hpp"

namespace vitrine {

LoadResult loadFor(const LoadRequest& request, FieldProber& prober) {
    LoadResult result;
    result.request = request;
    auto scene = std::make_shared<LoadedScene>();
    const ReadRecord record;
    try {
        *scene = loadAll(request.file, request.overrides, prober, result.problems);
    } catch (const InputError& error) {
        result.problems.append(error.diagnostics());
    }
    result.files = record.files();
    result.files.emplace(request.file, stampOf(request.file));
    if (!result.problems.hasErrors()) result.scene = std::move(scene);
    return result;
}

}  // namespace vitrine
