// SPDX-License-Identifier: MIT
#include "gltf/uri.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "gltf/test_model.hpp"

namespace vitrine {
namespace {

TEST(GltfUri, DecodesBase64) {
    EXPECT_EQ(decodeDataUri("data:;base64,"), "");
    EXPECT_EQ(decodeDataUri("data:text/plain;base64,TWFu"), "Man");
    EXPECT_EQ(decodeDataUri("data:;base64,TWE="), "Ma");
    EXPECT_EQ(decodeDataUri("data:;base64,TQ=="), "M");
    EXPECT_EQ(decodeDataUri("data:;base64,TQ"), "M") << "some writers leave the padding out";
    std::string all;
    for (int i = 0; i < 256; ++i) {
        all += static_cast<char>(i);
        EXPECT_EQ(decodeDataUri("data:;base64," + base64(all)), all);
        EXPECT_LE(all.size(), maxDataUriBytes("data:;base64," + base64(all)));
    }
    for (const char* bad : {"data:", "data:text/plain,hello", "data:;base64", "data:;base64,T",
                            "data:;base64,TW F", "data:;base64,TW=u", "data:;base64,===="})
        EXPECT_THROW(decodeDataUri(bad), std::invalid_argument) << bad;
}

TEST(GltfUri, DecodesPercentSigns) {
    EXPECT_EQ(decodeFileUri("a/b.bin"), "a/b.bin");
    EXPECT_EQ(decodeFileUri("%61%2Fb%c3%A4"), "a/bä");
    EXPECT_EQ(decodeFileUri("a+b#c?d"), "a+b#c?d");
    EXPECT_EQ(decodeFileUri("./1:2"), "./1:2");
    for (const char* bad : {"%", "%4", "%zz", "a%", "http://x/y", "file:///x", "C:/x",
                            "DATA:;base64,", "a\\b", "a%5Cb"})
        EXPECT_THROW(decodeFileUri(bad), std::invalid_argument) << bad;
    EXPECT_THROW(decodeFileUri(std::string(5000, 'a')), std::invalid_argument);
}

TEST(GltfUri, MessagesShowOnlyTheBeginning) {
    EXPECT_EQ(uriInQuotes("a b"), "'a b'");
    EXPECT_LT(uriInQuotes("data:;base64," + std::string(10000, 'A')).size(), 60u);
}

}  // namespace
}  // namespace vitrine
