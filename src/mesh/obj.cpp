// SPDX-License-Identifier: MIT
#include "mesh/obj.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <map>

#include "mesh/corner_table.hpp"
#include "mesh/obj_lexer.hpp"
#include "mesh/triangulate.hpp"

namespace vitrine {
namespace {

std::string plural(uint64_t count, const char* what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

/// Things that are skipped, told once with the place of the first.
struct Skipped {
    uint64_t count = 0;
    ObjToken first;

    void add(const ObjToken& token) {
        if (count++ == 0) first = token;
    }
};

class ObjReader {
  public:
    ObjReader(std::string_view text, const std::string& file, Diagnostics& diagnostics,
              const ObjLimits& limits)
        : lexer_(text),
          file_(file),
          diagnostics_(diagnostics),
          limits_(limits),
          triangulator_(limits.earTests) {}

    std::optional<Mesh> run() {
        while (!stopped_) {
            const ObjToken keyword = lexer_.nextStatement();
            if (keyword.text.empty()) break;
            readStatement(keyword);
        }
        reportSkipped();
        if (errors_ > limits_.errors)
            diagnostics_.error({file_}, "and " + plural(errors_ - limits_.errors, "more error"));
        if (errors_ > 0) return {};
        return finish();
    }

  private:
    void error(const ObjToken& at, std::string message) {
        if (++errors_ <= limits_.errors)
            diagnostics_.error({file_, at.line, at.column}, std::move(message));
    }

    /// A budget is used up: nothing that follows can be trusted.
    void stop(const ObjToken& at, std::string message) {
        error(at, std::move(message));
        stopped_ = true;
    }

    void readStatement(const ObjToken& keyword) {
        const std::string_view word = keyword.text;
        if (word == "v") {
            readVector(keyword, 3, positions_);
        } else if (word == "vn") {
            readVector(keyword, 3, normals_);
        } else if (word == "vt") {
            readVector(keyword, 1, uvs_);
        } else if (word == "f" || word == "fo") {
            readFace(keyword);
        } else if (word == "usemtl") {
            readName(material_);
        } else if (word == "g") {
            readName(group_);
        } else if (word == "o") {
            readName(object_);
            if (mesh_.name.empty()) mesh_.name = object_;
        } else if (word == "s") {
            readSmoothing(keyword);
        } else if (word == "mtllib") {
            libraries_.add(keyword);
        } else if (word == "l" || word == "p") {
            linesAndPoints_.add(keyword);
        } else {
            unknown_.add(keyword);
        }
    }

    /// Numbers beyond those wanted (weights, colours) are not looked at.
    template <typename Vector>
    void readVector(const ObjToken& keyword, int least, std::vector<Vector>& list) {
        Vector value(0.0f);
        for (int i = 0; i < Vector::length(); ++i) {
            const ObjToken word = lexer_.nextWord();
            if (word.text.empty()) {
                if (i < least)
                    error(keyword, fmt::format("{} needs {}, this one has {}", keyword.text,
                                               plural(least, "number"), i));
                break;
            }
            const std::optional<float> number = parseObjNumber(word.text);
            if (!number) {
                error(word, quoteObjWord(word.text) + " is not a number");
                break;
            }
            value[i] = *number;
        }
        // Kept even if it is wrong, so that the indices of what follows stay right.
        list.push_back(value);
        if (list.size() > limits_.vertices)
            stop(keyword,
                 fmt::format("more than {} {} statements", limits_.vertices, keyword.text));
    }

    void readName(std::string& name) {
        ObjToken word = lexer_.restOfLine();
        if (word.text.size() > limits_.nameBytes) {
            error(word, fmt::format("a name of more than {} bytes", limits_.nameBytes));
            word.text = word.text.substr(0, limits_.nameBytes);
        }
        name = cleanObjName(word.text);
        partIsKnown_ = false;
    }

    void readSmoothing(const ObjToken& keyword) {
        const std::string_view word = lexer_.nextWord().text;
        uint32_t group = Smoothing::kFlat;
        if (word != "off") {
            const auto [end, problem] =
                std::from_chars(word.data(), word.data() + word.size(), group);
            if (problem != std::errc() || end != word.data() + word.size()) {
                unknown_.add(keyword);
                return;
            }
        }
        smoothingGroup_ = group;
        hasSmoothing_ = true;
    }

    void readFace(const ObjToken& keyword) {
        face_.clear();
        for (;;) {
            const ObjToken word = lexer_.nextWord();
            if (word.text.empty()) break;
            if (face_.size() == limits_.corners) {
                error(keyword, fmt::format("a face of more than {} corners", limits_.corners));
                return;
            }
            CornerTable::Key key{};
            if (!readCorner(word, key)) return;
            face_.push_back(key);
        }
        if (face_.size() < 3) {
            error(keyword,
                  fmt::format("a face needs at least 3 corners, this one has {}", face_.size()));
            return;
        }
        addFace(keyword);
    }

    bool readCorner(const ObjToken& word, CornerTable::Key& key) {
        std::string_view fields[3];
        size_t count = 0, start = 0;
        for (size_t i = 0; i <= word.text.size(); ++i) {
            if (i < word.text.size() && word.text[i] != '/') continue;
            if (count == 3) return notACorner(word);
            fields[count++] = word.text.substr(start, i - start);
            start = i + 1;
        }
        return readIndex(word, fields[0], "vertex", positions_.size(), key.position) &&
               (fields[1].empty()
                    ? (key.uv = CornerTable::kNone, true)
                    : readIndex(word, fields[1], "texture coordinate", uvs_.size(), key.uv)) &&
               (fields[2].empty()
                    ? (key.normal = CornerTable::kNone, true)
                    : readIndex(word, fields[2], "normal", normals_.size(), key.normal));
    }

    bool notACorner(const ObjToken& word) {
        error(word, quoteObjWord(word.text) +
                        " is not a corner: expected v, v/vt, v//vn or v/vt/vn with whole numbers");
        return false;
    }

    bool readIndex(const ObjToken& word, std::string_view field, const char* what, size_t count,
                   uint32_t& result) {
        int64_t index = 0;
        const auto [end, problem] =
            std::from_chars(field.data(), field.data() + field.size(), index);
        if (end != field.data() + field.size() || problem == std::errc::invalid_argument)
            return notACorner(word);
        const auto size = static_cast<int64_t>(count);
        if (problem == std::errc::result_out_of_range || index > size || index < -size) {
            error(word,
                  fmt::format("{} {} does not exist: there {} {} so far", what,
                              cleanObjName(field.substr(0, 24)), size == 1 ? "is" : "are", size));
            return false;
        }
        if (index == 0) {
            error(word, fmt::format("{} 0 does not exist: indices count from 1", what));
            return false;
        }
        result = static_cast<uint32_t>(index > 0 ? index - 1 : size + index);
        return true;
    }

    void addFace(const ObjToken& keyword) {
        if (mesh_.triangles.size() + face_.size() - 2 > limits_.triangles) {
            stop(keyword, fmt::format("more than {} triangles", limits_.triangles));
            return;
        }
        polygon_.clear();
        vertices_.clear();
        for (const CornerTable::Key& key : face_) {
            polygon_.push_back(positions_[key.position]);
            vertices_.push_back(vertexOf(key));
        }
        if (table_.size() > limits_.vertices) {
            stop(keyword, fmt::format("more than {} different corners", limits_.vertices));
            return;
        }
        const size_t first = mesh_.triangles.size();
        triangulator_.triangulate(polygon_, mesh_.triangles);
        if (triangulator_.exhausted()) {
            stop(keyword, "too many large concave polygons: cut them into triangles beforehand");
            return;
        }
        for (size_t t = first; t < mesh_.triangles.size(); ++t) {
            glm::uvec3& v = mesh_.triangles[t];
            v = {vertices_[v.x], vertices_[v.y], vertices_[v.z]};
        }
        mesh_.triangleParts.resize(mesh_.triangles.size(), currentPart(keyword));
        smoothing_.groups.resize(mesh_.triangles.size(), smoothingGroup_);
    }

    uint32_t vertexOf(const CornerTable::Key& key) {
        const uint32_t vertex = table_.findOrAdd(key);
        if (vertex == mesh_.positions.size()) {
            constexpr uint32_t kNone = CornerTable::kNone;
            mesh_.positions.push_back(positions_[key.position]);
            mesh_.uvs.push_back(key.uv == kNone ? glm::vec2(0.0f) : uvs_[key.uv]);
            mesh_.normals.push_back(key.normal == kNone ? glm::vec3(0.0f) : normals_[key.normal]);
        }
        return vertex;
    }

    uint32_t currentPart(const ObjToken& keyword) {
        if (partIsKnown_) return part_;
        const std::string& name = !material_.empty() ? material_
                                  : !group_.empty()  ? group_
                                  : !object_.empty() ? object_
                                                     : kDefaultPart;
        const auto [entry, isNew] =
            parts_.emplace(name, static_cast<uint32_t>(mesh_.partNames.size()));
        if (isNew) mesh_.partNames.push_back(name);
        if (mesh_.partNames.size() > limits_.parts)
            stop(keyword, fmt::format("more than {} parts", limits_.parts));
        partIsKnown_ = true;
        return part_ = entry->second;
    }

    void reportSkipped() {
        const auto warn = [this](const Skipped& skipped, const std::string& message) {
            if (skipped.count > 0)
                diagnostics_.warning({file_, skipped.first.line, skipped.first.column}, message);
        };
        warn(libraries_, "mtllib is not read: the scene file gives materials to parts");
        warn(linesAndPoints_,
             plural(linesAndPoints_.count, "line or point statement") + " skipped");
        warn(unknown_, plural(unknown_.count, "statement") + " not understood, the first is " +
                           quoteObjWord(unknown_.first.text));
    }

    std::optional<Mesh> finish() {
        if (!hasSmoothing_) smoothing_.groups.clear();
        Diagnostics found;
        sanitizeMesh(mesh_, {file_}, found, std::move(smoothing_));
        diagnostics_.append(found);
        if (found.hasErrors()) return {};
        return std::move(mesh_);
    }

    inline static const std::string kDefaultPart = "default";

    ObjLexer lexer_;
    const std::string& file_;
    Diagnostics& diagnostics_;
    const ObjLimits& limits_;
    int64_t errors_ = 0;
    bool stopped_ = false;
    Skipped libraries_, linesAndPoints_, unknown_;

    std::vector<glm::vec3> positions_, normals_;
    std::vector<glm::vec2> uvs_;
    CornerTable table_;
    Triangulator triangulator_;
    std::vector<CornerTable::Key> face_;
    std::vector<glm::vec3> polygon_;
    std::vector<uint32_t> vertices_;

    std::string material_, group_, object_;
    std::map<std::string, uint32_t> parts_;
    uint32_t part_ = 0;
    bool partIsKnown_ = false;
    uint32_t smoothingGroup_ = Smoothing::kByAngle;
    bool hasSmoothing_ = false;
    Smoothing smoothing_;
    Mesh mesh_;
};

/// The place of the first NUL byte, if there is one.
std::optional<SourceLocation> findNul(std::string_view text, const std::string& file) {
    const size_t at = text.find('\0');
    if (at == text.npos) return {};
    const std::string_view before = text.substr(0, at);
    const auto lines = std::count(before.begin(), before.end(), '\n');
    const size_t lineStart = before.rfind('\n') == before.npos ? 0 : before.rfind('\n') + 1;
    return SourceLocation{file, static_cast<int>(lines) + 1, static_cast<int>(at - lineStart) + 1};
}

}  // namespace

std::optional<Mesh> readObj(std::string_view text, const std::string& file,
                            Diagnostics& diagnostics, const ObjLimits& limits) {
    if (const auto nul = findNul(text, file)) {
        diagnostics.error(*nul, "a NUL byte: this is not a text file");
        return {};
    }
    return ObjReader(text, file, diagnostics, limits).run();
}

}  // namespace vitrine
