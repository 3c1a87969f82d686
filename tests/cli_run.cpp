// SPDX-License-Identifier: MIT
#include "cli_run.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>

#include "base/file.hpp"

namespace vitrine {
namespace fs = std::filesystem;
namespace {

fs::path makeFolder() {
    std::string name = fs::temp_directory_path() / "vitrine-cli-XXXXXX";
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    return name;
}

/// In the child: never returns.
[[noreturn]] void become(const std::vector<std::string>& command,
                         const std::vector<std::string>& environment, const fs::path& folder,
                         const fs::path& outputs) {
    const auto open = [&](const char* name, int descriptor) {
        const int file = ::open((outputs / name).c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        ::dup2(file, descriptor);
    };
    open("out", STDOUT_FILENO);
    open("err", STDERR_FILENO);
    for (const std::string& entry : environment) ::putenv(const_cast<char*>(entry.c_str()));
    std::vector<char*> arguments;
    for (const std::string& argument : command)
        arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    if (::chdir(folder.c_str()) == 0) ::execv(arguments[0], arguments.data());
    std::_Exit(127);
}

/// The status of waitpid; kills what takes longer than `seconds`.
int waitFor(pid_t child, double seconds) {
    const auto start = std::chrono::steady_clock::now();
    int status = 0;
    while (::waitpid(child, &status, WNOHANG) == 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        if (elapsed.count() < seconds) continue;
        ::kill(child, SIGKILL);
        ::waitpid(child, &status, 0);
        break;
    }
    return status;
}

}  // namespace

void CliTest::SetUp() {
    folder = makeFolder();
    outputs_ = makeFolder();
}

void CliTest::TearDown() {
    fs::remove_all(folder);
    fs::remove_all(outputs_);
}

void CliTest::write(const std::string& file, std::string_view text) const {
    fs::create_directories((folder / file).parent_path());
    writeFileAtomically(folder / file, text);
}

std::string CliTest::read(const std::string& file) const {
    return readFile(folder / file, 1 << 26);
}

std::vector<std::string> CliTest::files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

Outcome CliTest::run(const std::vector<std::string>& arguments,
                     const std::vector<std::string>& environment, double seconds) const {
    std::vector<std::string> command{VITRINE_PROGRAM};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const pid_t child = ::fork();
    if (child == 0) become(command, environment, folder, outputs_);
    const int status = waitFor(child, seconds);
    Outcome outcome;
    if (WIFEXITED(status)) outcome.code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) outcome.signal = WTERMSIG(status);
    outcome.out = readFile(outputs_ / "out", 1 << 26);
    outcome.err = readFile(outputs_ / "err", 1 << 26);
    return outcome;
}

}  // namespace vitrine
