// SPDX-License-Identifier: MIT
#include "scene/options.hpp"

namespace vitrine {
namespace {

constexpr Range kAnyNumber{-1e9, 1e9};
constexpr Range kPositive{1e-6, 1e9};
constexpr Range kUnit{0, 1};
constexpr Range kNotNegative{0, 1e9};
constexpr Range kNone{};

template <class T, class E>
ChoiceMember<T> choice(std::vector<std::string> words, E T::*member) {
    return {std::move(words), [member](T& t, int i) { t.*member = static_cast<E>(i); },
            [member](const T& t) { return static_cast<int>(t.*member); }};
}

/// In the order of Channel.
std::vector<std::string> channelNames() {
    return {"r", "g", "b", "a", "1-r", "1-g", "1-b", "1-a"};
}

/// In the order of Ease.
std::vector<std::string> easeNames() {
    return {"linear", "step", "smooth", "smoother", "in", "out"};
}

}  // namespace

const OptionTable<Scene>& sceneOptions() {
    static const OptionTable<Scene> table{
        {"title", &Scene::title, kNone, "shown in the window and written into pictures"},
        {"description", &Scene::description, kNone, "what there is to see"},
    };
    return table;
}

const OptionTable<RenderSettings>& renderOptions() {
    using R = RenderSettings;
    static const OptionTable<R> table{
        {"bounces", &R::bounces, {0, 32}, "mirror reflections followed after the camera ray"},
        {"samples", &R::samples, {1, 65536}, "samples a pixel (`--spp` wins)"},
        {"ssaa", &R::ssaa, {1, 4}, "supersampling: 2 draws 2 x 2 and averages"},
        {"exposure", &R::exposure, {-20, 20}, "stops; +1 doubles the light"},
        {"gamma", &R::gamma, {0.1, 10}, "extra gamma on top of sRGB; above 1 is brighter"},
        {"exposure_percent",
         &R::exposurePercent,
         {0, 100000},
         "factor on the light on top of exposure: 100 as it is, 200 doubles it"},
        {"tone_map", choice<R>({"none", "filmic", "aces", "agx", "reinhard"}, &R::toneMap), kNone,
         "curve from scene light to display light"},
        {"threshold", &R::threshold, kUnit, "a path ends when less than this of its light is left"},
        {"shadows", choice<R>({"sampled", "penumbra"}, &R::shadows), kNone,
         "of lights with a size: sampled: all of it, exact, wants `--spp`; penumbra: one ray each, "
         "soft behind fields and hard behind meshes"},
        {"ao", &R::ao, {0, 5}, "ambient occlusion: 0 off, 1 natural, up to 5 dramatic"},
        {"ao_mode", choice<R>({"rays", "taps"}, &R::aoMode), kNone,
         "taps: on fields five looks along the normal, which see fields alone; meshes keep rays"},
        {"ao_distance", &R::aoDistance, kPositive, "reach of ambient occlusion, m"},
        {"sss_all", &R::sssAll, kUnit, "every material has at least this much subsurface"},
        {"march_steps", &R::marchSteps, {8, 4096}, "most steps of one ray through one field"},
        {"seed", &R::seed, {0, 2147483647}, "start of the random numbers (`--seed` wins)"},
        {"budget_ms",
         &R::budgetMilliseconds,
         {5, 1000},
         "in the window, while something moves: what a frame may take, ms; resolution follows"},
    };
    return table;
}

const OptionTable<TreeSettings>& bvhOptions() {
    using T = TreeSettings;
    static const OptionTable<T> table{
        {"builder", choice<T>({kTreeBuilderNames.begin(), kTreeBuilderNames.end()}, &T::builder),
         kNone,
         "nine: the best of three cuts along each axis; binned: fast; spatial: cuts triangles too"},
        {"max_leaf_size", &T::maxLeafSize, {1, 16}, "most triangles in a leaf; 1 makes all alone"},
        {"traversal_cost",
         &T::traversalCost,
         {0.01, 100},
         "cost of a node, in tests of a triangle; more makes larger leaves"},
        {"max_duplicates",
         &T::maxDuplicates,
         {0, 8},
         "spatial: most parts of cut triangles beyond the first, for each triangle of the mesh"},
        {"min_overlap", &T::minOverlap, kUnit,
         "spatial: planes are tried where boxes share this part of the whole's area; 0: "
         "everywhere"},
    };
    return table;
}

const OptionTable<Camera>& cameraOptions() {
    using C = Camera;
    static const OptionTable<C> table{
        {"name", &C::name, kNone, "for `--camera`"},
        {"eye", &C::eye, kAnyNumber, "position, m"},
        {"target", &C::target, kAnyNumber, "point in the middle of the picture, m"},
        {"up", &C::up, kAnyNumber, "direction that is up in the picture"},
        {"fov", &C::fov, {0.1, 170}, "vertical field of view, degrees"},
        {"focal_length",
         &C::focalLength,
         {1, 2000},
         "instead of fov: mm on a 36 mm wide sensor; 35 if neither is given"},
        {"f_stop",
         &C::fStop,
         {0, 1000},
         "aperture number, focal length over the lens's diameter; 0: a pinhole, all is sharp"},
        {"focus_distance", &C::focusDistance, kNotNegative,
         "along the view axis, m: what is sharp; 0: the target"},
        {"aperture_blades",
         &C::apertureBlades,
         {0, 16},
         "corners of blurred points of light; 0 (or below 3): round"},
        {"lens", choice<C>({"sampled", "filter"}, &C::lens), kNone,
         "who blurs with f_stop: sampled: rays through all of the lens, wants `--spp`; filter: one "
         "sharp sample, blurred by its depth"},
        {"loop", choice<C>({"none", "repeat", "mirror"}, &C::loop), kNone,
         "of path: after its last key stay, begin again, go back and forth"},
    };
    return table;
}

const OptionTable<CameraOrbit>& orbitOptions() {
    using O = CameraOrbit;
    static const OptionTable<O> table{
        {"period",
         &O::period,
         {-1e6, 1e6},
         "seconds a turn, counterclockwise seen from above; negative: clockwise"},
        {"distance", &O::distance, kPositive, "from the target, m; not given: as far as eye"},
        {"elevation", &O::elevation, {-89, 89}, "degrees above the target; not given: as eye is"},
        {"azimuth", &O::azimuth, kAnyNumber,
         "where it begins, degrees from +z towards +x; not given: as eye is"},
    };
    return table;
}

const OptionTable<Environment>& environmentOptions() {
    using E = Environment;
    static const OptionTable<E> table{
        {"zenith", &E::zenith, kNotNegative, "radiance from straight above"},
        {"horizon", &E::horizon, kNotNegative, "radiance from the horizon"},
        {"ground", &E::ground, kNotNegative,
         "radiance from below; with `sky = \"sun\"` the ground's reflectance"},
        {"sun_elevation",
         &E::sunElevation,
         {-18, 90},
         "degrees above the horizon; needs `sky = \"sun\"`"},
        {"sun_azimuth", &E::sunAzimuth, kAnyNumber,
         "degrees from +z towards +x; needs `sky = \"sun\"`"},
        {"turbidity",
         &E::turbidity,
         {1, 10},
         "haze: 1 pure air, 2 clear, 6 hazy; needs `sky = \"sun\"`"},
        {"rotation", &E::rotation, kAnyNumber,
         "degrees about +y by which a picture (or an atmosphere) is turned"},
        {"intensity", &E::intensity, kNotNegative, "factor on all of it"},
    };
    return table;
}

const OptionTable<Light>& lightOptions() {
    using L = Light;
    static const OptionTable<L> table{
        {"name", &L::name, kNone, "for `--set light.NAME.key=value`"},
        {"type", choice<L>({"sun", "point", "spot", "sphere", "rect"}, &L::type), kNone,
         "kind of light; a sphere is a point light with a size that can be seen"},
        {"at", &L::at, kAnyNumber, "position of all but a sun, m"},
        {"direction", &L::direction, kAnyNumber, "way the light of a sun, spot or rect travels"},
        {"polar",
         &L::polar,
         {0, 180},
         "instead of direction, where the light of a sun or spot comes from: degrees from the "
         "zenith"},
        {"azimuth", &L::azimuth, {-360, 360}, "with polar: degrees from +z towards +x"},
        {"color", &L::color, kNotNegative, "colour"},
        {"intensity", &L::intensity, kNotNegative,
         "sun: irradiance, W/m2; others: W/sr (of a rect, straight ahead)"},
        {"radius", &L::radius, kNotNegative,
         "size, for soft shadows: m; of a sun degrees (ours: 0.27); 0 makes hard shadows"},
        {"size", ScaleMember<L>{&L::size}, kNotNegative,
         "rect: width and height, m; z is not used"},
        {"inner_angle", &L::innerAngle, {0, 90}, "spot: full light within, degrees from the axis"},
        {"outer_angle", &L::outerAngle, {0, 90}, "spot: no light beyond, degrees from the axis"},
        {"range", &L::range, kNotNegative, "nothing is lit beyond, m; 0: no end"},
    };
    return table;
}

const OptionTable<Material>& materialOptions() {
    using M = Material;
    static const OptionTable<M> table{
        {"base_color", &M::baseColor, kUnit, "colour of the body, or of a metal's mirror image"},
        {"metallic", &M::metallic, kUnit, "0 for plastics, stone, paint; 1 for bare metal"},
        {"roughness", &M::roughness, kUnit, "0 mirror, 1 matt"},
        {"emission", &M::emission, kNotNegative, "light given off, radiance"},
        {"emission_strength", &M::emissionStrength, kNotNegative, "factor on emission"},
        {"base_color_texture", TextureMember<M>{&M::baseColorTexture}, kNone,
         "picture (PNG or JPEG), times base_color"},
        {"metallic_roughness_texture", TextureMember<M>{&M::metallicRoughnessTexture}, kNone,
         "picture whose channels multiply roughness and metallic"},
        {"roughness_from", choice<M>(channelNames(), &M::roughnessFrom), kNone,
         "channel of that picture; 1-r reads a glossiness from red"},
        {"metallic_from", choice<M>(channelNames(), &M::metallicFrom), kNone,
         "channel of that picture"},
        {"normal_texture", TextureMember<M>{&M::normalTexture}, kNone,
         "picture of tangent-space normals, +Y up"},
        {"normal_scale", &M::normalScale, {-10, 10}, "how strongly it bends the normals"},
        {"occlusion_texture", TextureMember<M>{&M::occlusionTexture}, kNone,
         "picture whose red channel dims ambient light"},
        {"occlusion_strength", &M::occlusionStrength, kUnit, "how much of that"},
        {"emission_texture", TextureMember<M>{&M::emissionTexture}, kNone,
         "picture, times emission"},
        {"opacity", &M::opacity, kUnit, "times the alpha of base_color_texture; see alpha_mode"},
        {"alpha_mode", choice<M>({"opaque", "mask", "blend"}, &M::alphaMode), kNone,
         "mask: there are holes where opacity is below alpha_cutoff; blend: it lets light pass"},
        {"alpha_cutoff", &M::alphaCutoff, {0, 1e9}, "for alpha_mode mask"},
        {"double_sided", &M::doubleSided, kNone, "false: its back is not seen (shadows stay)"},
        {"unlit", &M::unlit, kNone, "shows base_color whatever the light is"},
        {"ior", &M::ior, {1, 10}, "index of refraction: 1.33 water, 1.5 glass, 2.42 diamond"},
        {"specular", &M::specular, kUnit, "strength of the reflection of what is not metal"},
        {"specular_color", &M::specularColor, kNotNegative, "its colour, seen straight on"},
        {"specular_texture", TextureMember<M>{&M::specularTexture}, kNone,
         "picture whose alpha multiplies specular"},
        {"specular_color_texture", TextureMember<M>{&M::specularColorTexture}, kNone,
         "picture, times specular_color"},
        {"transmission", &M::transmission, kUnit, "1 for glass and water: light goes through"},
        {"transmission_texture", TextureMember<M>{&M::transmissionTexture}, kNone,
         "picture whose red channel multiplies transmission"},
        {"thin", &M::thin, kNone, "a sheet or a bubble: light passes without refraction"},
        {"attenuation_color", &M::attenuationColor, kUnit,
         "what is left of white light after attenuation_distance inside"},
        {"attenuation_distance", &M::attenuationDistance, kNotNegative, "m; 0: clear"},
        {"clearcoat", &M::clearcoat, kUnit, "a layer of varnish over everything"},
        {"clearcoat_texture", TextureMember<M>{&M::clearcoatTexture}, kNone,
         "picture whose red channel multiplies clearcoat"},
        {"clearcoat_roughness", &M::clearcoatRoughness, kUnit, "of the varnish"},
        {"clearcoat_roughness_texture", TextureMember<M>{&M::clearcoatRoughnessTexture}, kNone,
         "picture whose green channel multiplies clearcoat_roughness"},
        {"clearcoat_normal_texture", TextureMember<M>{&M::clearcoatNormalTexture}, kNone,
         "picture of the varnish's normals"},
        {"clearcoat_normal_scale", &M::clearcoatNormalScale, {-10, 10}, "how strongly"},
        {"sheen_color", &M::sheenColor, kUnit, "glow of cloth and velvet seen edge on"},
        {"sheen_color_texture", TextureMember<M>{&M::sheenColorTexture}, kNone,
         "picture, times sheen_color"},
        {"sheen_roughness", &M::sheenRoughness, kUnit, "of the cloth's fibres"},
        {"sheen_roughness_texture", TextureMember<M>{&M::sheenRoughnessTexture}, kNone,
         "picture whose alpha multiplies sheen_roughness"},
        {"subsurface", &M::subsurface, kUnit,
         "wax, leaves, skin: how much light comes through from behind"},
        {"subsurface_color", &M::subsurfaceColor, kUnit, "of that light, times base_color"},
        {"subsurface_radius", &M::subsurfaceRadius, kPositive,
         "m of the substance that leave 1/e (37 %) of it"},
        {"model", choice<M>({"pbr", "lambert", "blinn-phong"}, &M::model), kNone,
         "pbr: all of the above; lambert, blinn-phong: base_color and lights alone, as in "
         "textbooks"},
        {"highlight_color", &M::highlightColor, kUnit,
         "blinn-phong: share of light in the highlight, the specular colour of textbooks"},
        {"shininess", &M::shininess, {1, 1e5}, "blinn-phong: exponent of the highlight"},
        {"snippet", FileMember<M>{&M::snippet}, kNone,
         "NAME.mat.glsl with `void material(inout Surface s)`"},
        {"curvature_radius", &M::curvatureRadius, kPositive,
         "m: on fields, what `s.curvature` in a snippet is taken over"},
    };
    return table;
}

const OptionTable<Shape>& shapeOptions() {
    static const OptionTable<Shape> table{
        {"sdf", FileMember<Shape>{&Shape::sdf}, kNone, "NAME.sdf.glsl with `float sdf(vec3 p)`"},
        {"mesh", FileMember<Shape>{&Shape::mesh}, kNone, "NAME.obj, NAME.gltf or NAME.glb"},
    };
    return table;
}

const OptionTable<BoxShape>& boxOptions() {
    static const OptionTable<BoxShape> table{
        {"size", ScaleMember<BoxShape>{&BoxShape::size}, kPositive, "edges, m"}};
    return table;
}

const OptionTable<SphereShape>& sphereOptions() {
    static const OptionTable<SphereShape> table{{"radius", &SphereShape::radius, kPositive, "m"}};
    return table;
}

const OptionTable<PlaneShape>& planeOptions() {
    static const OptionTable<PlaneShape> table{{"size", ScaleMember<PlaneShape>{&PlaneShape::size},
                                                kNotNegative,
                                                "edges along x and z, m; y is not used"}};
    return table;
}

const OptionTable<TorusShape>& torusOptions() {
    static const OptionTable<TorusShape> table{
        {"radius", &TorusShape::radius, kPositive, "from the centre to the middle of the tube, m"},
        {"tube", &TorusShape::tube, kPositive, "radius of the tube, m"},
        {"segments", &TorusShape::segments, {3, 2048}, "quads around the ring"},
        {"sides", &TorusShape::sides, {3, 1024}, "quads around the tube"},
        {"arc", &TorusShape::arc, {1, 360}, "part of the ring from +x towards -z, degrees"}};
    return table;
}

const OptionTable<CylinderShape>& cylinderOptions() {
    static const OptionTable<CylinderShape> table{
        {"radius", &CylinderShape::radius, kPositive, "m"},
        {"height", &CylinderShape::height, kPositive, "m"}};
    return table;
}

const OptionTable<Node>& nodeOptions() {
    static const OptionTable<Node> table{
        {"name", &Node::name, kNone, "for `parent` and `--set node.NAME.key=value`"},
        {"parent", &Node::parent, kNone, "node whose place this one's is relative to"},
        {"shape", &Node::shape, kNone, "what stands here; none makes a group"},
        {"include", FileMember<Node>{&Node::include}, kNone,
         "instead of shape: NAME.gltf or NAME.glb, all that is in it"},
        {"animation", &Node::animation, kNone,
         "of that file, the one that plays, or none; else the first"},
        {"material", &Node::material, kNone, "of all parts that `parts` does not name"},
        {"at", &Node::at, kAnyNumber, "position, m"},
        {"rotate", &Node::rotate, kAnyNumber, "degrees about x, then y, then z"},
        {"scale", ScaleMember<Node>{&Node::scale}, kAnyNumber, "one factor, or one an axis"},
        {"visible", &Node::visible, kNone, "false hides it, and what hangs on it, from every ray"},
    };
    return table;
}

const OptionTable<AnimationEntry>& animationOptions() {
    using A = AnimationEntry;
    static const OptionTable<A> table{
        {"name", &A::name, kNone, "for `--set animation.NAME.key=value`"},
        {"node", &A::node, kNone, "what moves: a node, a camera, a light or a material"},
        {"camera", &A::camera, kNone, "the same"},
        {"light", &A::light, kNone, "the same"},
        {"material", &A::material, kNone, "the same"},
        {"param", &A::param, kNone, "the key of it that changes, as in `--set`"},
        {"ease", choice<A>(easeNames(), &A::ease), kNone,
         "how it goes from key to key: evenly, in jumps, slowly at both ends, at the first, at the "
         "second"},
        {"loop", choice<A>({"none", "repeat", "mirror"}, &A::loop), kNone,
         "after the last key: stay, begin again, go back and forth"},
    };
    return table;
}

}  // namespace vitrine
