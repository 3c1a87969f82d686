// SPDX-License-Identifier: MIT
// Reading a scene anew: what is asked for, and what comes of it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/session/session.hpp"
#include "base/file.hpp"

namespace vitrine {

struct LoadRequest {
    std::string file;
    std::vector<std::string> overrides;
    int number = 0;          ///< of the request, from 1
    int editsVersion = 0;    ///< the edits in `overrides`
    bool sameText = false;   ///< the scene's own text, but for numbers, is the one that is shown
    bool otherFile = false;  ///< another file than the one that is shown
};

struct LoadResult {
    LoadRequest request;
    std::shared_ptr<LoadedScene> scene;  ///< null: it cannot be shown
    ModelLibrary models;                 ///< those that it names
    Diagnostics problems;
    FileStamps files;  ///< it has been read from
};

/// On any thread; `prober` asks on a context that is current there. Whatever is wrong, even with
/// the file itself, is in the result. The cache is of the loads before.
LoadResult loadFor(const LoadRequest& request, FieldProber& prober, SceneCache& cache);

}  // namespace vitrine
