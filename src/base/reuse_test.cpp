// SPDX-License-Identifier: MIT
#include "base/reuse.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

namespace vitrine {
namespace fs = std::filesystem;

class ReuseTest : public testing::Test {
  protected:
    void SetUp() override {
        file = fs::temp_directory_path() / ("vitrine-reuse-" + std::to_string(::getpid()));
        write("one");
    }
    void TearDown() override { fs::remove(file); }
    void write(const std::string& text) const { std::ofstream(file) << text; }
    std::shared_ptr<const std::string> get(const std::string& key = "key") {
        return kept.get(key,
                        [&] { return std::make_shared<const std::string>(readFile(file, 100)); });
    }
    fs::path file;
    Reuse<std::string> kept;
};

TEST_F(ReuseTest, KeepsWhatWasMadeUntilItsFileChanges) {
    const auto first = get();
    EXPECT_EQ(get(), first);
    EXPECT_EQ(kept.made(), 1);
    write("longer");
    EXPECT_EQ(*get(), "longer");
    EXPECT_EQ(*get("another key"), "longer");
    EXPECT_EQ(kept.made(), 3);
    kept.forget("key");
    (void)get();
    EXPECT_EQ(kept.made(), 4);
}

TEST_F(ReuseTest, WhoRecordsLearnsOfTheFilesEvenIfNobodyReadsThem) {
    (void)get();
    const ReadRecord record;
    (void)get();
    EXPECT_EQ(kept.made(), 1);
    EXPECT_EQ(record.files(), (FileStamps{{file, stampOf(file)}}));
}

TEST_F(ReuseTest, ForgetsWhatIsNotAskedFor) {
    (void)get("a");
    (void)get("b");
    kept.sweep();
    (void)get("a");
    kept.sweep();
    (void)get("a");
    EXPECT_EQ(kept.made(), 2);
    (void)get("b");
    EXPECT_EQ(kept.made(), 3);
}

TEST_F(ReuseTest, FailuresAreNotKept) {
    int tries = 0;
    for (int i = 0; i < 2; ++i)
        EXPECT_EQ(kept.get("key",
                           [&] {
                               ++tries;
                               return std::shared_ptr<const std::string>();
                           }),
                  nullptr);
    EXPECT_EQ(tries, 2);
}

}  // namespace vitrine
