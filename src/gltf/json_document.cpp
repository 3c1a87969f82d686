// SPDX-License-Identifier: MIT
// nlohmann's own tree builder neither counts nor refuses repeated keys, so this is one of ours on
// top of its event parser, which keeps its state in a vector of bits and cannot overflow the stack.
#include "gltf/json_document.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <vector>

namespace vitrine {
namespace {

using Json = nlohmann::json;

/// Its functions are named by nlohmann's interface; false ends the parsing.
class TreeBuilder {
  public:
    explicit TreeBuilder(const JsonLimits& limits) : limits_(limits) {}

    bool null() { return add(nullptr); }
    bool boolean(bool value) { return add(value); }
    bool number_integer(int64_t value) { return add(value); }
    bool number_unsigned(uint64_t value) { return add(value); }
    bool number_float(double value, const std::string&) { return add(value); }
    bool string(std::string& value) { return add(std::move(value)); }
    bool binary(Json::binary_t&) { return false; }  // JSON text has none
    bool start_object(size_t) { return open(Json::object()); }
    bool end_object() { return close(); }
    bool start_array(size_t) { return open(Json::array()); }
    bool end_array() { return close(); }
    bool key(std::string& name) {
        const auto [place, isNew] = open_.back()->get_ref<Json::object_t&>().emplace(name, nullptr);
        if (!isNew)
            return fail(fmt::format("the key {} comes twice in one object", inQuotes(name)));
        member_ = &place->second;
        return true;
    }
    bool parse_error(size_t byte, const std::string&, const Json::exception& exception) {
        errorByte = byte;
        return fail(readable(exception.what()));
    }

    Json root;
    std::string error;
    size_t errorByte = 0;  ///< counts from 1; 0: not known

  private:
    bool fail(std::string message) {
        error = std::move(message);
        return false;
    }

    bool add(Json&& value) { return insert(std::move(value)) != nullptr; }

    Json* insert(Json&& value) {
        if (values_++ >= limits_.values) {
            fail(fmt::format("more than {} values", limits_.values));
            return nullptr;
        }
        Json* place = &root;
        if (member_ != nullptr) {
            place = std::exchange(member_, nullptr);
            *place = std::move(value);
        } else if (!open_.empty()) {
            auto& array = open_.back()->get_ref<Json::array_t&>();
            array.push_back(std::move(value));
            place = &array.back();
        } else {
            root = std::move(value);
        }
        return place;
    }

    bool open(Json&& container) {
        if (static_cast<int>(open_.size()) >= limits_.depth)
            return fail(fmt::format("nested deeper than {} levels", limits_.depth));
        Json* place = insert(std::move(container));
        if (place == nullptr) return false;
        open_.push_back(place);
        return true;
    }
    bool close() {
        open_.pop_back();
        return true;
    }

    /// Without nlohmann's code number and its own count of lines.
    static std::string readable(std::string_view what) {
        if (const size_t bracket = what.find("] "); bracket != what.npos)
            what.remove_prefix(bracket + 2);
        if (what.substr(0, 14) == "parse error at")
            if (const size_t colon = what.find(": "); colon != what.npos)
                what.remove_prefix(colon + 2);
        constexpr size_t kLongest = 200;
        std::string text(what.substr(0, kLongest));
        for (char& c : text)
            if (static_cast<unsigned char>(c) < 32 || static_cast<unsigned char>(c) > 126) c = '?';
        return text;
    }

    JsonLimits limits_;
    uint64_t values_ = 0;
    std::vector<Json*> open_;  // containers that are not closed yet; parents do not move meanwhile
    Json* member_ = nullptr;   // where the value of the last key goes
};

}  // namespace

std::optional<Json> parseJson(std::string_view text, const JsonLimits& limits, Report& report) {
    TreeBuilder builder(limits);
    if (Json::sax_parse(text.begin(), text.end(), &builder)) return std::move(builder.root);
    if (builder.errorByte > 0)
        report.errorAtByte(builder.errorByte - 1, "JSON: " + builder.error);
    else
        report.error("", "JSON: " + builder.error);
    return {};
}

}  // namespace vitrine
