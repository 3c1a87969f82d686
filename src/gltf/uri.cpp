// SPDX-License-Identifier: MIT
#include "gltf/uri.hpp"

#include <array>
#include <cstdint>
#include <stdexcept>

#include "gltf/report.hpp"

namespace vitrine {
namespace {

constexpr std::string_view kDataScheme = "data:";
constexpr std::string_view kBase64Mark = ";base64";
// Longer than any path the system accepts.
constexpr size_t kMaxFileUri = 4096;
constexpr size_t kShownOfDataUri = 40;

bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

/// "http:" and the like. A Windows drive, "C:", looks the same and is as unwelcome.
bool hasScheme(std::string_view uri) {
    if (uri.empty() || !isLetter(uri[0])) return false;
    for (const char c : uri) {
        if (c == ':') return true;
        if (!isLetter(c) && !isDigit(c) && c != '+' && c != '-' && c != '.') return false;
    }
    return false;
}

int hexDigit(char c) {
    if (isDigit(c)) return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

constexpr int kNotBase64 = -1;

constexpr std::array<int8_t, 256> base64Values() {
    std::array<int8_t, 256> values{};
    values.fill(kNotBase64);
    constexpr std::string_view kAlphabet =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < kAlphabet.size(); ++i)
        values[static_cast<unsigned char>(kAlphabet[i])] = static_cast<int8_t>(i);
    return values;
}

std::string decodeBase64(std::string_view text) {
    static constexpr std::array<int8_t, 256> kValues = base64Values();
    // The padding carries no information; some writers leave it out.
    for (int i = 0; i < 2 && !text.empty() && text.back() == '='; ++i) text.remove_suffix(1);
    if (text.size() % 4 == 1) throw std::invalid_argument("the base64 data is cut short");
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        const int value = kValues[static_cast<unsigned char>(c)];
        if (value == kNotBase64)
            throw std::invalid_argument("the base64 data has a character that is not allowed");
        bits = (bits << 6) | static_cast<uint32_t>(value);
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += static_cast<char>((bits >> count) & 0xff);
    }
    return bytes;
}

}  // namespace

bool isDataUri(std::string_view uri) {
    return uri.substr(0, kDataScheme.size()) == kDataScheme;
}

size_t maxDataUriBytes(std::string_view uri) {
    return uri.size() / 4 * 3 + 2;
}

std::string decodeDataUri(std::string_view uri) {
    const size_t comma = uri.find(',');
    if (comma == std::string_view::npos)
        throw std::invalid_argument("the data: URI has no comma before its data");
    const std::string_view type = uri.substr(0, comma);
    if (type.size() < kBase64Mark.size() ||
        type.substr(type.size() - kBase64Mark.size()) != kBase64Mark)
        throw std::invalid_argument("a data: URI must be in base64");
    return decodeBase64(uri.substr(comma + 1));
}

std::string decodeFileUri(std::string_view uri) {
    if (uri.size() > kMaxFileUri) throw std::invalid_argument("the file name is too long");
    if (hasScheme(uri))
        throw std::invalid_argument("only files in the model's own folder and data: URIs are read");
    std::string name;
    for (size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] != '%') {
            name += uri[i];
            continue;
        }
        const int high = i + 2 < uri.size() ? hexDigit(uri[i + 1]) : -1;
        const int low = i + 2 < uri.size() ? hexDigit(uri[i + 2]) : -1;
        if (high < 0 || low < 0)
            throw std::invalid_argument("'%' must be followed by two hexadecimal digits");
        name += static_cast<char>(high * 16 + low);
        i += 2;
    }
    // On other systems it leads into folders, so a file with it is not portable.
    if (name.find('\\') != std::string::npos)
        throw std::invalid_argument("the file name contains '\\'; folders are separated by '/'");
    return name;
}

std::string uriInQuotes(std::string_view uri) {
    return inQuotes(isDataUri(uri) ? uri.substr(0, kShownOfDataUri) : uri);
}

}  // namespace vitrine
