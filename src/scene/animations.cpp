// SPDX-License-Identifier: MIT
#include "scene/animations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <unordered_map>

#include "scene/target.hpp"
#include "scene/values.hpp"

namespace vitrine {
namespace {

using Object = AnimationTarget::Object;
using Words = std::vector<std::string>;

constexpr size_t kMaxKeys = 10'000;       // of one animation
constexpr size_t kMaxValues = 1'000'000;  // of all; one path may mean every light
constexpr Range kTimes{0, 1e6};

const std::vector<std::pair<std::string, Object>>& objectKinds() {
    static const std::vector<std::pair<std::string, Object>> kinds{
        {"render", Object::kRender},     {"environment", Object::kEnvironment},
        {"camera", Object::kCamera},     {"light", Object::kLight},
        {"material", Object::kMaterial}, {"node", Object::kNode}};
    return kinds;
}

/// The objects of each kind by their names.
class ObjectNames {
  public:
    explicit ObjectNames(const Scene& scene) {
        add(Object::kCamera, scene.cameras);
        add(Object::kLight, scene.lights);
        add(Object::kMaterial, scene.materials);
        add(Object::kNode, scene.nodes);
    }
    [[nodiscard]] size_t count(Object kind) const { return lists_.at(kind).count; }
    [[nodiscard]] std::optional<size_t> find(Object kind, const std::string& name) const {
        const auto& indexOf = lists_.at(kind).indexOf;
        const auto found = indexOf.find(name);
        if (found == indexOf.end() || name.empty()) return {};
        return found->second;
    }
    [[nodiscard]] std::string hint(Object kind, const std::string& name) const {
        constexpr size_t kMostToCompare = 500;  // a huge scene, error by error, would take minutes
        const auto& indexOf = lists_.at(kind).indexOf;
        if (indexOf.size() > kMostToCompare) return "";
        Words names;
        for (const auto& [known, index] : indexOf) names.push_back(known);
        return didYouMean(name, names);
    }

  private:
    struct List {
        size_t count = 0;
        std::unordered_map<std::string, size_t> indexOf;
    };
    template <class T>
    void add(Object kind, const std::vector<T>& objects) {
        List& list = lists_[kind];
        list.count = objects.size();
        for (size_t i = 0; i < objects.size(); ++i) list.indexOf.emplace(objects[i].name, i);
    }
    std::map<Object, List> lists_;
};

/// Where a path of words leads, with what is wrong about it. One track moves each target.
class TargetFinder {
  public:
    TargetFinder(const Scene& scene, const ObjectNames& names, Diagnostics& diagnostics)
        : scene_(scene), names_(names), diagnostics_(diagnostics) {}

    /// `object` and `param` are the places of the words that name the object and its key.
    std::vector<AnimationTarget> find(const Words& words, const SourceLocation& object,
                                      const SourceLocation& param) {
        const auto kind = std::find_if(objectKinds().begin(), objectKinds().end(),
                                       [&](const auto& k) { return k.first == words[0]; });
        if (kind == objectKinds().end()) {
            Words names;
            for (const auto& [name, unused] : objectKinds()) names.push_back(name);
            diagnostics_.error(
                object, words[0] == "shape"
                            ? "shapes do not change with time; a node's scale can"
                            : fmt::format("'{}' has nothing that can change with time{}", words[0],
                                          didYouMean(words[0], names)));
            return {};
        }
        const bool single = kind->second == Object::kRender || kind->second == Object::kEnvironment;
        if (words.size() < 2 || (!single && words.size() == 2 && kind->second != Object::kCamera &&
                                 kind->second != Object::kLight)) {
            diagnostics_.error(param,
                               fmt::format("the key is missing, as in {}",
                                           single ? words[0] + ".KEY" : words[0] + ".NAME.KEY"));
            return {};
        }
        const size_t keyAt = single || words.size() == 2 ? 1 : 2;
        AnimationTarget target;
        target.object = kind->second;
        target.key = fmt::format("{}", fmt::join(words.begin() + keyAt, words.end(), "."));
        std::vector<AnimationTarget> targets;
        for (const size_t index : objects(words, target.object, keyAt, object)) {
            target.index = index;
            // One word for three colours, as in the section itself.
            if (target.object == Object::kEnvironment && target.key == "sky") {
                for (const char* key : {"zenith", "horizon", "ground"})
                    targets.push_back({target.object, 0, key});
            } else if (exists(target, param)) {
                targets.push_back(target);
            } else {
                return {};
            }
        }
        return targets;
    }

  private:
    std::vector<size_t> objects(const Words& words, Object kind, size_t keyAt,
                                const SourceLocation& where) {
        if (kind == Object::kRender || kind == Object::kEnvironment) return {0};
        if (keyAt == 2) {
            if (const auto index = names_.find(kind, words[1])) return {*index};
            diagnostics_.error(where, fmt::format("no {} is named '{}'{}", words[0], words[1],
                                                  names_.hint(kind, words[1])));
            return {};
        }
        std::vector<size_t> all(names_.count(kind));
        std::iota(all.begin(), all.end(), 0);
        if (kind == Object::kCamera && all.size() > 1) all.resize(1);
        if (all.empty()) diagnostics_.error(where, fmt::format("the scene has no {}", words[0]));
        return all;
    }

    bool exists(const AnimationTarget& target, const SourceLocation& where) {
        const bool hasSet = target.object == Object::kNode || target.object == Object::kMaterial;
        if (hasSet && parameterOf(target.key)) return true;  // pack/ knows the snippet
        return visitTarget(scene_, target, [&](const auto& options, const auto&) {
            const auto* option = findOption(options, target.key);
            if (option == nullptr) {
                Words keys;
                for (const auto& each : options)
                    if (canChange(each)) keys.push_back(each.key);
                diagnostics_.error(where, fmt::format("there is no '{}' to animate{}", target.key,
                                                      didYouMean(target.key, keys)));
            } else if (!canChange(*option)) {
                diagnostics_.error(where, fmt::format("'{}' cannot change with time", target.key));
            } else {
                return true;
            }
            return false;
        });
    }

    const Scene& scene_;
    const ObjectNames& names_;
    Diagnostics& diagnostics_;
};

class AnimationReader {
  public:
    AnimationReader(const std::vector<std::string>& overrides, Scene& scene,
                    Diagnostics& diagnostics)
        : scene_(scene), names_(scene), diagnostics_(diagnostics) {
        Diagnostics unheard;  // --set has been complained about
        for (const std::string& assignment : overrides) {
            const Words words =
                splitKey(std::string_view(assignment).substr(0, assignment.find('=')));
            for (AnimationTarget& target : TargetFinder(scene, names_, unheard).find(words, {}, {}))
                fixed_.insert(std::move(target));
        }
    }

    void take(AnimationTrack track) {
        const SourceLocation where = track.where;
        add(std::move(track), where);
    }

    void read(const toml::table& table) {
        AnimationEntry entry;
        readTable(table, "[[animation]]", animationOptions(), {"keys"}, entry, diagnostics_);
        const SourceLocation where = placeOf(table);
        const toml::node* keys = table.get("keys");
        if (entry.param.empty() || keys == nullptr) {
            diagnostics_.error(where, "an animation needs param and keys");
            return;
        }
        Words words;
        SourceLocation object = entry.param.where;
        for (const auto& [kind, name] : {std::pair{"node", &entry.node},
                                         {"camera", &entry.camera},
                                         {"light", &entry.light},
                                         {"material", &entry.material}}) {
            if (name->empty()) continue;
            if (!words.empty()) {
                diagnostics_.error(name->where,
                                   fmt::format("give {} or {}, not both", words[0], kind));
                return;
            }
            words = {kind, name->name};
            object = name->where;
        }
        for (std::string& word : splitKey(entry.param.name)) words.push_back(std::move(word));
        // A path that means every light is not looked up once more for every animation.
        const auto [path, isNew] = paths_.emplace(words, where);
        if (!isNew) return complain(entry.param.where, path->second);
        const std::vector<AnimationTarget> targets =
            TargetFinder(scene_, names_, diagnostics_).find(words, object, entry.param.where);
        const size_t count = keys->is_array() ? keys->as_array()->size() : 0;
        valueCount_ += count * targets.size();
        if (valueCount_ > kMaxValues) {
            diagnostics_.error(where, fmt::format("with this, the animations have more than {} "
                                                  "keys together",
                                                  kMaxValues));
            return;
        }
        for (const AnimationTarget& target : targets) {
            AnimationTrack track;
            track.target = target;
            track.ease = entry.ease;
            track.loop = entry.loop;
            track.where = where;
            if (!readKeys(*keys, track) || !add(std::move(track), entry.param.where)) return;
        }
    }

  private:
    void complain(const SourceLocation& where, const SourceLocation& other) {
        diagnostics_.error(where, fmt::format("this is animated already, at {}", other.text()));
    }

    bool add(AnimationTrack track, const SourceLocation& where) {
        const auto [known, isNew] = places_.emplace(track.target, track.where);
        if (!isNew)
            complain(where, known->second);
        else if (fixed_.count(track.target) == 0)
            scene_.animations.push_back(std::move(track));
        return isNew;
    }

    bool readKeys(const toml::node& node, AnimationTrack& track) {
        const toml::array* keys = node.as_array();
        const auto isPair = [](const toml::node& key) {
            return key.is_array() && key.as_array()->size() == 2;
        };
        if (keys == nullptr || keys->empty() || !std::all_of(keys->begin(), keys->end(), isPair)) {
            const auto* wrong = &node;
            if (keys != nullptr)
                for (const toml::node& key : *keys)
                    if (wrong == &node && !isPair(key)) wrong = &key;
            diagnostics_.error(placeOf(*wrong),
                               "keys must be pairs, as in [[0, VALUE], [1.5, VALUE]]");
            return false;
        }
        if (keys->size() > kMaxKeys) {
            diagnostics_.error(placeOf(node), fmt::format("there are {} keys, at most {} are read",
                                                          keys->size(), kMaxKeys));
            return false;
        }
        int components = 0;
        for (const toml::node& key : *keys) {
            const toml::array& pair = *key.as_array();
            double time = 0;
            if (!readNumber(*pair.get(0), "the time", kTimes, time, diagnostics_)) return false;
            if (!track.times.empty() && static_cast<float>(time) <= track.times.back()) {
                diagnostics_.error(placeOf(*pair.get(0)),
                                   "times must grow from key to key; this one does not");
                return false;
            }
            track.times.push_back(static_cast<float>(time));
            if (!readValue(*pair.get(1), track, components)) return false;
        }
        if (track.loop != LoopMode::kNone && track.times.size() < 2) {
            diagnostics_.error(placeOf(node), "a loop needs two keys or more");
            return false;
        }
        track.loopStart = track.times.front();
        track.loopEnd = track.times.back();
        return true;
    }

    bool readValue(const toml::node& node, AnimationTrack& track, int& components) {
        if (const auto parameter = parameterOf(track.target.key)) {
            ParameterValue value;
            if (!readParameter(node, track.target.key, value, diagnostics_)) return false;
            if (components != 0 && components != value.components) {
                diagnostics_.error(value.where,
                                   "this key has another number of components than the first");
                return false;
            }
            components = track.components = value.components;
            track.values.push_back(value.value);
            return true;
        }
        return visitTarget(scene_, track.target, [&](const auto& options, const auto& object) {
            const auto& option = *findOption(options, track.target.key);
            auto scratch = object;
            const size_t mistakes = diagnostics_.list().size();
            readOption(node, option, scratch, diagnostics_);
            track.values.push_back(numbersOf(option, scratch));
            if (isTruthValue(option)) track.interpolation = Interpolation::kStep;
            return diagnostics_.list().size() == mistakes;
        });
    }

    Scene& scene_;
    const ObjectNames names_;
    Diagnostics& diagnostics_;
    std::set<AnimationTarget> fixed_;                   ///< by `--set`
    std::map<AnimationTarget, SourceLocation> places_;  ///< of what is animated
    std::map<Words, SourceLocation> paths_;             ///< as they are written
    size_t valueCount_ = 0;
};

}  // namespace

void readAnimations(const toml::array* tables, std::vector<AnimationTrack> ways,
                    const std::vector<std::string>& overrides, Scene& scene,
                    Diagnostics& diagnostics) {
    if (tables == nullptr && ways.empty()) return;
    AnimationReader reader(overrides, scene, diagnostics);
    for (AnimationTrack& way : ways) reader.take(std::move(way));
    if (tables == nullptr) return;
    for (const toml::node& entry : *tables)
        if (const toml::table* table = entry.as_table()) reader.read(*table);
}

}  // namespace vitrine
