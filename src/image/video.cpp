// SPDX-License-Identifier: MIT
#include "image/video.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cassert>
#include <cerrno>
#include <cstring>
#include <vector>

#include "base/error.hpp"
#include "base/file.hpp"

namespace vitrine {
namespace {

constexpr uint64_t kMaxLogBytes = 1u << 20;

/// How to encode, by the file's extension.
std::vector<std::string> codecArguments(const std::string& extension) {
    // Two of the three codecs keep colour at half the resolution and want an even size.
    const std::string even = "pad=ceil(iw/2)*2:ceil(ih/2)*2,";
    const std::string color = "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p";
    const std::vector<std::string> tags{"-colorspace", "bt709", "-color_primaries", "bt709",
                                        "-color_trc",  "bt709", "-color_range",     "tv"};
    std::vector<std::string> arguments;
    if (extension == ".gif")
        return {"-vf", "split[a][b];[a]palettegen=stats_mode=diff[p];[b][p]paletteuse", "-f",
                "gif"};
    if (extension == ".webm")
        arguments = {"-vf",     even + color, "-c:v",      "libvpx-vp9", "-crf",      "24",
                     "-b:v",    "0",          "-deadline", "good",       "-cpu-used", "4",
                     "-row-mt", "1",          "-f",        "webm"};
    else
        arguments = {"-vf",     even + color, "-c:v",      "libx264",    "-crf", "16",
                     "-preset", "medium",     "-movflags", "+faststart", "-f",   "mp4"};
    arguments.insert(arguments.end() - 2, tags.begin(), tags.end());
    return arguments;
}

}  // namespace

bool isVideoName(const std::filesystem::path& file) {
    const std::string extension = file.extension().string();
    return extension == ".mp4" || extension == ".webm" || extension == ".gif";
}

VideoWriter::VideoWriter(std::filesystem::path file, int width, int height, double framesPerSecond)
    : file_(std::move(file)), width_(width), height_(height) {
    checkWritable(file_);
    unfinished_ = file_.string() + fmt::format(".{}.part", ::getpid());
    log_ = unfinished_.string() + ".log";
    start(framesPerSecond);
}

VideoWriter::~VideoWriter() {
    abandon();
}

void VideoWriter::start(double framesPerSecond) {
    std::vector<std::string> arguments{"ffmpeg",       "-nostdin",
                                       "-hide_banner", "-loglevel",
                                       "error",        "-y",
                                       "-f",           "rawvideo",
                                       "-pix_fmt",     "rgba",
                                       "-s",           fmt::format("{}x{}", width_, height_),
                                       "-framerate",   fmt::format("{}", framesPerSecond),
                                       "-i",           "pipe:0"};
    for (const std::string& a : codecArguments(file_.extension().string())) arguments.push_back(a);
    // "file:" keeps a name with a colon from being taken for a protocol.
    arguments.push_back("file:" + unfinished_.string());
    std::vector<char*> pointers;
    for (std::string& a : arguments) pointers.push_back(a.data());
    pointers.push_back(nullptr);

    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0)
        throw MachineError(fmt::format("cannot make a pipe: {}", std::strerror(errno)));
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, log_.c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    const int error =
        ::posix_spawnp(&process_, "ffmpeg", &actions, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    ::close(ends[0]);
    pipe_ = ends[1];
    if (error == 0) return;
    process_ = -1;
    abandon();
    throw MachineError(error == ENOENT
                           ? std::string("films need the program 'ffmpeg'; on Debian "
                                         "install the package of that name")
                           : fmt::format("cannot start ffmpeg: {}", std::strerror(error)));
}

void VideoWriter::add(const ImageRgba8& picture) {
    assert(picture.width == width_ && picture.height == height_);
    const auto* bytes = reinterpret_cast<const char*>(picture.pixels.data());
    const size_t size = static_cast<size_t>(width_) * static_cast<size_t>(height_) * 4;
    // A dead ffmpeg must be an error of this call and not the end of this process.
    struct sigaction ignore {
    }, before{};
    ignore.sa_handler = SIG_IGN;
    ::sigaction(SIGPIPE, &ignore, &before);
    size_t done = 0;
    bool good = true;
    while (done < size && good) {
        const ssize_t n = ::write(pipe_, bytes + done, size - done);
        if (n < 0 && errno == EINTR) continue;
        good = n >= 0;
        if (good) done += static_cast<size_t>(n);
    }
    ::sigaction(SIGPIPE, &before, nullptr);
    if (!good) fail();
}

void VideoWriter::finish() {
    ::close(pipe_);
    pipe_ = -1;
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) fail();
    // Only what is on the disk is renamed to the name that people look for.
    const int written = ::open(unfinished_.c_str(), O_RDONLY | O_CLOEXEC);
    const bool synced = written >= 0 && ::fsync(written) == 0;
    if (written >= 0) ::close(written);
    if (!synced || ::rename(unfinished_.c_str(), file_.c_str()) != 0)
        throw MachineError(
            fmt::format("cannot write '{}': {}", file_.string(), std::strerror(errno)));
    ::unlink(log_.c_str());
    unfinished_.clear();
}

std::string VideoWriter::complaint() {
    try {
        const std::string text = readFile(log_, kMaxLogBytes);
        return text.empty() ? "it ended without a word" : text.substr(0, text.find('\n'));
    } catch (const InputError&) {
        return "it left no message";
    }
}

void VideoWriter::fail() {
    const std::string why = complaint();
    abandon();
    throw MachineError(fmt::format("cannot write '{}': ffmpeg: {}", file_.string(), why));
}

void VideoWriter::abandon() {
    if (pipe_ >= 0) ::close(pipe_);
    pipe_ = -1;
    if (process_ > 0) {
        ::kill(process_, SIGTERM);
        while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
        }
        process_ = -1;
    }
    if (unfinished_.empty()) return;
    ::unlink(unfinished_.c_str());
    ::unlink(log_.c_str());
    unfinished_.clear();
}

}  // namespace vitrine
