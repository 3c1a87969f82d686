// SPDX-License-Identifier: MIT
#include "app/viewer/load.hpp"

namespace vitrine {

LoadResult loadFor(const LoadRequest& request, FieldProber& prober, SceneCache& cache) {
    LoadResult result;
    result.request = request;
    auto scene = std::make_shared<LoadedScene>();
    const ReadRecord record;
    try {
        *scene = loadAll(request.file, request.overrides, prober, cache, result.problems);
    } catch (const InputError& error) {
        result.problems.append(error.diagnostics());
    }
    result.files = record.files();
    result.files.emplace(request.file, stampOf(request.file));
    if (result.problems.hasErrors()) return result;
    // Not before: what a mistake hides for a moment is needed again when it is mended.
    cache.sweep();
    result.scene = std::move(scene);
    result.models = cache.models;
    return result;
}

}  // namespace vitrine
