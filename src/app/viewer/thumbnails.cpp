// SPDX-License-Identifier: MIT
#include "app/viewer/thumbnails.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <tbb/task_arena.h>

#include <optional>
#include <sstream>
#include <utility>

#include "app/session/session.hpp"
#include "app/viewer/user_folders.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "image/png.hpp"

namespace vitrine {
namespace {

constexpr int kSamples = 4;
constexpr uint64_t kMaxSceneBytes = 16u << 20;
constexpr uint64_t kMaxPictureBytes = 4u << 20, kMaxFilesBytes = 4u << 20;

struct Stopped {};

std::filesystem::path filesBeside(std::filesystem::path picture) {
    return picture += ".files";
}

std::optional<ImageRgba8> readPicture(const std::filesystem::path& file) {
    try {
        if (!areUnchanged(readFile(filesBeside(file), kMaxFilesBytes))) return {};
        const std::string bytes = readFile(file, kMaxPictureBytes);
        const std::span data(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size());
        if (pngSize(data, file.string()) != ImageSize{Thumbnails::kWidth, Thumbnails::kHeight})
            return {};
        return decodePng(data, file.string());
    } catch (const InputError&) {
        return {};
    }
}

}  // namespace

std::string thumbnailName(std::string_view text, std::string_view version) {
    uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a
    const auto add = [&hash](std::string_view bytes) {
        for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
        hash = (hash ^ bytes.size()) * 0x100000001b3u;
    };
    add(version);
    add(text);
    return fmt::format("scene-{:016x}.png", hash);
}

std::string thumbnailFiles(const FileStamps& files) {
    std::string text;
    for (const auto& [path, stamp] : files)
        text +=
            fmt::format("{} {} {} {}\n", stamp.nanoseconds, stamp.size, stamp.inode, path.string());
    return text;
}

bool areUnchanged(std::string_view thumbnailFiles) {
    std::istringstream lines{std::string(thumbnailFiles)};
    FileStamp then;
    bool any = false;
    for (std::string path; lines >> then.nanoseconds >> then.size >> then.inode;) {
        lines.ignore(1);
        std::getline(lines, path);
        if (stampOf(path) != then) return false;
        any = true;
    }
    return any && lines.eof();
}

Thumbnails::Thumbnails(std::vector<std::string> files, std::filesystem::path cache,
                       std::string version)
    : files_(std::move(files)),
      cache_(std::move(cache)),
      version_(std::move(version)),
      thread_([this] { run(); }) {}

Thumbnails::~Thumbnails() {
    {
        const std::lock_guard lock(mutex_);
        stopped_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

std::vector<Thumbnails::Result> Thumbnails::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(results_, {});
}

void Thumbnails::setPaused(bool paused) {
    {
        const std::lock_guard lock(mutex_);
        paused_ = paused;
    }
    changed_.notify_all();
}

bool Thumbnails::shouldStop() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return stopped_ || !paused_; });
    return stopped_;
}

void Thumbnails::deliver(size_t scene, ImageRgba8 picture) {
    const std::lock_guard lock(mutex_);
    results_.push_back({scene, std::move(picture)});
}

void Thumbnails::run() {
    // On Linux this is the calling thread's, and of those that it starts: a driver's own.
    (void)::setpriority(PRIO_PROCESS, 0, 19);
    // What is there comes first.
    std::vector<std::pair<size_t, std::filesystem::path>> missing;
    for (size_t i = 0; i < files_.size(); ++i) {
        std::filesystem::path kept;
        try {
            if (!cache_.empty())
                kept = cache_ / thumbnailName(readFile(files_[i], kMaxSceneBytes), version_);
        } catch (const InputError&) {
            deliver(i, {});
            continue;
        }
        auto picture = kept.empty() ? std::nullopt : readPicture(kept);
        if (picture)
            deliver(i, std::move(*picture));
        else
            missing.emplace_back(i, kept);
    }
    // All that could be done side by side is done by this thread alone.
    tbb::task_arena alone(1);
    for (const auto& [i, kept] : missing) {
        if (shouldStop()) return;
        ImageRgba8 picture;
        FileStamps files;
        try {
            alone.execute([&, scene = i] { picture = draw(files_[scene], files); });
        } catch (const Stopped&) {
            return;
        } catch (const std::exception&) {
            deliver(i, {});  // opening it will say why
            continue;
        }
        if (!kept.empty()) {
            const std::vector<uint8_t> bytes = encodePng(picture);
            if (keepFile(kept, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}))
                (void)keepFile(filesBeside(kept), thumbnailFiles(files));
        }
        deliver(i, std::move(picture));
    }
}

ImageRgba8 Thumbnails::draw(const std::string& file, FileStamps& files) {
    Diagnostics diagnostics;
    const ReadRecord record;
    const LoadedScene loaded = loadAll(file, {}, diagnostics);
    files = record.files();
    diagnostics.throwIfErrors();
    if (shouldStop()) throw Stopped{};
    Renderer renderer(loaded, Backend::kAuto, false);
    PictureRequest request;
    request.width = kWidth;
    request.height = kHeight;
    request.samples = kSamples;
    return renderer.draw(request, [this](int, int) {
        finishGpu();
        if (shouldStop()) throw Stopped{};
    });
}

}  // namespace vitrine
