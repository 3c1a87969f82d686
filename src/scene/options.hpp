// SPDX-License-Identifier: MIT
// Options are declared once: a table a struct, a row an option. The rows drive the parser, the
// defaults, the ranges, `--set`, the list of keys in "did you mean" and the printed reference.
#pragma once

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "scene/scene.hpp"

namespace vitrine {

/// A member that is one of a list of words.
template <class T>
struct ChoiceMember {
    std::vector<std::string> words;
    std::function<void(T&, int)> set;
    std::function<int(const T&)> get;
};

/// A scale: three numbers, or one for all.
template <class T>
struct ScaleMember {
    glm::vec3 T::*member;
};

/// The name of a file, relative to the file that it is written in.
template <class T>
struct FileMember {
    Reference T::*member;
};

/// The file of a texture.
template <class T>
struct TextureMember {
    MaterialTexture T::*member;
};

template <class T>
using OptionMember =
    std::variant<float T::*, int T::*, bool T::*, glm::vec3 T::*, Color T::*, std::string T::*,
                 Reference T::*, ScaleMember<T>, FileMember<T>, TextureMember<T>, ChoiceMember<T>>;

/// Inclusive; what lies outside is an error.
struct Range {
    double minimum = -1e9;
    double maximum = 1e9;
};

template <class T>
struct Option {
    std::string key;
    OptionMember<T> member;
    Range range;
    std::string help;
};

template <class T>
using OptionTable = std::vector<Option<T>>;

/// An [[animation]] as it is written, but for its keys.
struct AnimationEntry {
    std::string name;
    Reference node, camera, light, material, param;
    Ease ease = Ease::kLinear;
    LoopMode loop = LoopMode::kNone;
};

const OptionTable<RenderSettings>& renderOptions();
const OptionTable<TreeSettings>& bvhOptions();
const OptionTable<Camera>& cameraOptions();
const OptionTable<CameraOrbit>& orbitOptions();
const OptionTable<Environment>& environmentOptions();
const OptionTable<Light>& lightOptions();
const OptionTable<Material>& materialOptions();
const OptionTable<Shape>& shapeOptions();
const OptionTable<BoxShape>& boxOptions();
const OptionTable<SphereShape>& sphereOptions();
const OptionTable<PlaneShape>& planeOptions();
const OptionTable<TorusShape>& torusOptions();
const OptionTable<CylinderShape>& cylinderOptions();
const OptionTable<Node>& nodeOptions();
const OptionTable<AnimationEntry>& animationOptions();
const OptionTable<Scene>& sceneOptions();

/// The reference of the scene format in Markdown, made from the tables (docs/scene-format.md).
std::string sceneFormatReference();

}  // namespace vitrine
