// SPDX-License-Identifier: MIT
// Runs the built program in a folder of its own, as a user would, and keeps all that came out.
#pragma once

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

struct Outcome {
    int code = -1;    ///< exit code; -1: did not exit by itself
    int signal = 0;   ///< what ended it, if not an exit
    std::string out;  ///< standard output
    std::string err;  ///< standard error
};

class CliTest : public testing::Test {
  protected:
    void SetUp() override;
    void TearDown() override;

    void write(const std::string& file, std::string_view text) const;
    [[nodiscard]] std::string read(const std::string& file) const;
    [[nodiscard]] bool exists(const std::string& file) const {
        return std::filesystem::exists(folder / file);
    }
    /// Names of the files in the folder, sorted.
    [[nodiscard]] std::vector<std::string> files() const;

    /// `environment` is added to this process's own: "NAME=value". Nothing may take longer than
    /// `seconds`; what does is killed.
    [[nodiscard]] Outcome run(const std::vector<std::string>& arguments,
                              const std::vector<std::string>& environment = {},
                              double seconds = 120) const;

    std::filesystem::path folder;

  private:
    /// Where the output goes; not in `folder`, whose files are looked at.
    std::filesystem::path outputs_;
};

}  // namespace vitrine
