// SPDX-License-Identifier: MIT
#include "base/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "base/error.hpp"

namespace vitrine {
namespace fs = std::filesystem;
namespace {

/// A file descriptor that closes itself.
class Descriptor {
  public:
    explicit Descriptor(int fd) : fd_(fd) {}
    ~Descriptor() {
        if (fd_ >= 0) ::close(fd_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    [[nodiscard]] int get() const { return fd_; }
    /// Closes now, to see the error that a network or full disk may report only then.
    [[nodiscard]] bool close() { return ::close(std::exchange(fd_, -1)) == 0; }

  private:
    int fd_;
};

[[noreturn]] void failWriting(const fs::path& path, int error) {
    throw MachineError(fmt::format("cannot write '{}': {}", path.string(), std::strerror(error)));
}

/// Where writing to `path` ends up: behind links, so that a link stays one. Renaming onto a device
/// or a pipe would replace it by a file.
fs::path writingTarget(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::is_directory(status)) failWriting(path, EISDIR);
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw MachineError(fmt::format("cannot write '{}': not a regular file", path.string()));
    return fs::is_symlink(path, error) && fs::exists(status) ? fs::canonical(path) : path;
}

thread_local ReadRecord* innermostRecord = nullptr;

/// The nearest existing ancestor resolved through links, the rest appended as written.
fs::path canonicalPrefix(const fs::path& path) {
    std::error_code error;
    fs::path result = fs::weakly_canonical(path, error);
    return error ? fs::absolute(path).lexically_normal() : result;
}

}  // namespace

ReadRecord::ReadRecord() : outer_(std::exchange(innermostRecord, this)) {}

ReadRecord::~ReadRecord() {
    innermostRecord = outer_;
    if (outer_ != nullptr) outer_->files_.merge(files_);
}

void ReadRecord::note(const FileStamps& files) {
    if (innermostRecord != nullptr) innermostRecord->files_.insert(files.begin(), files.end());
}

FileStamp stampOf(const fs::path& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return {};
    return {status.st_mtim.tv_sec * 1'000'000'000 + status.st_mtim.tv_nsec,
            static_cast<uint64_t>(status.st_size), static_cast<uint64_t>(status.st_ino)};
}

std::string readFile(const fs::path& path, uint64_t maxBytes) {
    // Before it is read: a change meanwhile is a change afterwards.
    if (innermostRecord != nullptr)
        innermostRecord->files_.emplace(path.lexically_normal(), stampOf(path));
    const auto fail = [&](const std::string& why) -> InputError {
        return {SourceLocation{path.string()}, why};
    };
    // O_NONBLOCK: opening a pipe without a writer must not hang.
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (file.get() < 0) throw fail(fmt::format("cannot read: {}", std::strerror(errno)));
    struct stat status {};
    if (::fstat(file.get(), &status) != 0) throw fail(std::strerror(errno));
    if (!S_ISREG(status.st_mode)) throw fail("not a regular file");
    if (static_cast<uint64_t>(status.st_size) > maxBytes)
        throw fail(
            fmt::format("too large: {} bytes, at most {} are read", status.st_size, maxBytes));

    std::string bytes;
    bytes.resize(static_cast<size_t>(status.st_size));
    size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t n = ::read(file.get(), bytes.data() + done, bytes.size() - done);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) throw fail(fmt::format("cannot read: {}", std::strerror(errno)));
        if (n == 0) break;  // the file shrank while it was read
        done += static_cast<size_t>(n);
    }
    bytes.resize(done);
    return bytes;
}

fs::path resolveInside(const fs::path& root, std::string_view reference) {
    if (reference.empty()) throw std::invalid_argument("the file name is empty");
    if (reference.find('\0') != std::string_view::npos)
        throw std::invalid_argument("the file name contains a zero byte");
    const fs::path relative(reference);
    if (relative.is_absolute())
        throw std::invalid_argument(
            "the path is absolute; write it relative to the scene's folder");
    const fs::path base = canonicalPrefix(root.empty() ? fs::path(".") : root);
    const fs::path target = canonicalPrefix(base / relative);
    const fs::path inside = target.lexically_relative(base);
    if (inside.empty() || *inside.begin() == "..")
        throw std::invalid_argument("the path leads out of the scene's folder");
    return (root.empty() ? relative : root / relative).lexically_normal();
}

void writeFileAtomically(const fs::path& name, std::span<const uint8_t> bytes) {
    const fs::path path = writingTarget(name);
    std::string temporary = path.string() + ".XXXXXX";
    Descriptor file(::mkstemp(temporary.data()));
    if (file.get() < 0) failWriting(path, errno);
    const auto fail = [&](int error) {
        ::unlink(temporary.c_str());
        failWriting(path, error);
    };
    size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t n = ::write(file.get(), bytes.data() + done, bytes.size() - done);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) fail(errno);
        done += static_cast<size_t>(n);
    }
    // mkstemp makes the file private; a picture is as readable as any other new file.
    const mode_t mask = ::umask(0);
    ::umask(mask);
    if (::fchmod(file.get(), 0666 & ~mask) != 0) fail(errno);
    if (::fsync(file.get()) != 0) fail(errno);
    if (!file.close()) fail(errno);
    if (::rename(temporary.c_str(), path.c_str()) != 0) fail(errno);
}

void writeFileAtomically(const fs::path& path, std::string_view text) {
    writeFileAtomically(path,
                        std::span(reinterpret_cast<const uint8_t*>(text.data()), text.size()));
}

void checkWritable(const fs::path& path) {
    const fs::path target = writingTarget(path);
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    if (::access(folder.c_str(), W_OK | X_OK) != 0) failWriting(path, errno);
}

}  // namespace vitrine
