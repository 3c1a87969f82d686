// SPDX-License-Identifier: MIT
// Numbers that C++ and GLSL must agree upon. Read by both compilers.
#ifndef VITRINE_LIMITS
#define VITRINE_LIMITS

// Entries of the traversal stack. pack/ proves for every scene that no ray needs more
// (each visit of a node keeps at most three of its four children for later).
#define VITRINE_STACK_SIZE 64

// Iterations that all loops of one shader invocation may take together. llvmpipe ends them silently
// after 65,535, counted over eight pixels in lockstep, whence the half.
#define VITRINE_LOOP_BUDGET 32768

// A slot of the acceleration structure is three RGBA32UI texels: a node, a triangle, or the number of
// an instance (pack/bvh_layout.hpp owns the format, trace/node.glsl reads it).
#define VITRINE_SLOT_TEXELS 3
#define VITRINE_LEAF_BIT 0x80000000u
#define VITRINE_LAST_TRIANGLE_BIT 0x80000000u

// Where the rasteriser's view begins, m before the eye (pack/camera.hpp).
#define VITRINE_NEAR_PLANE 0.001f

// Boxes drawn in one call: GLSL ES 3.00 promises no more than 256 uniform vectors.
#define VITRINE_BOXES_A_DRAW 32

// Instances: kinds of geometry, and texels of an entry of the instance table.
#define VITRINE_KIND_MESH 0
#define VITRINE_KIND_FIELD 1
// Added to the kind. FILTERED: some of its materials let rays pass. CULLED: none of its triangles is
// seen from behind.
#define VITRINE_INSTANCE_FILTERED 2
#define VITRINE_INSTANCE_CULLED 4
#define VITRINE_INSTANCE_TEXELS 9
#define VITRINE_MATERIAL_TEXELS 10
#define VITRINE_TEXTURE_SLOT_TEXELS 3
#define VITRINE_LIGHT_TEXELS 6
#define VITRINE_VERTEX_TEXELS 2

// What a texture slot of a material is for.
#define VITRINE_SLOT_BASE_COLOR 0
#define VITRINE_SLOT_METALLIC_ROUGHNESS 1
#define VITRINE_SLOT_NORMAL 2
#define VITRINE_SLOT_OCCLUSION 3
#define VITRINE_SLOT_EMISSION 4
#define VITRINE_SLOT_TRANSMISSION 5
#define VITRINE_SLOT_SPECULAR 6
#define VITRINE_SLOT_SPECULAR_COLOR 7
#define VITRINE_SLOT_CLEARCOAT 8
#define VITRINE_SLOT_CLEARCOAT_ROUGHNESS 9
#define VITRINE_SLOT_CLEARCOAT_NORMAL 10
#define VITRINE_SLOT_SHEEN_COLOR 11
#define VITRINE_SLOT_SHEEN_ROUGHNESS 12
#define VITRINE_SLOT_COUNT 13

// Light types, in the order of LightType (scene/scene.hpp).
#define VITRINE_LIGHT_SUN 0
#define VITRINE_LIGHT_POINT 1
#define VITRINE_LIGHT_SPOT 2
#define VITRINE_LIGHT_SPHERE 3
#define VITRINE_LIGHT_RECT 4

// Alpha modes, in the order of AlphaMode, and the other flags of a material.
#define VITRINE_ALPHA_MASK 1
#define VITRINE_ALPHA_BLEND 2
#define VITRINE_MATERIAL_SINGLE_SIDED 4
#define VITRINE_MATERIAL_UNLIT 8
#define VITRINE_MATERIAL_THIN 16
#define VITRINE_MATERIAL_CLASSIC 32

// Nodes of the table of directional albedos: by the cosine, by the roughness.
#define VITRINE_ALBEDO_COSINES 32
#define VITRINE_ALBEDO_ROUGHNESSES 16

// How light is followed, in the order of RenderMode (frame/frame.hpp).
#define VITRINE_MODE_HYBRID 0
#define VITRINE_MODE_REFERENCE 1

// What a path does where its camera ray meets a surface that light passes.
#define VITRINE_SPLIT_NONE 0
#define VITRINE_SPLIT_REFLECT 1
#define VITRINE_SPLIT_TRANSMIT 2

// Values of the instance word of a hit record that name no instance.
#define VITRINE_RECORD_NONE 0xffffffffu
#define VITRINE_RECORD_MISS 0xfffffffeu

// Views, in the order of the names in frame/view.cpp.
#define VITRINE_VIEW_COLOR 0
#define VITRINE_VIEW_ALBEDO 1
#define VITRINE_VIEW_NORMAL 2
#define VITRINE_VIEW_DEPTH 3
#define VITRINE_VIEW_INSTANCE 4
#define VITRINE_VIEW_PRIMITIVE 5
#define VITRINE_VIEW_BARYCENTRIC 6
#define VITRINE_VIEW_MATERIAL 7
#define VITRINE_VIEW_DIRECT 8
#define VITRINE_VIEW_SHADOW 9
#define VITRINE_VIEW_REFLECTION 10
#define VITRINE_VIEW_AO 11
#define VITRINE_VIEW_STEPS 12
#define VITRINE_VIEW_NODES 13
#define VITRINE_VIEW_LOOPS 14
#define VITRINE_VIEW_THICKNESS 15
#define VITRINE_VIEW_BVH 16

// Tone maps, in the order of ToneMap (scene/scene.hpp).
#define VITRINE_TONE_NONE 0
#define VITRINE_TONE_FILMIC 1
#define VITRINE_TONE_ACES 2
#define VITRINE_TONE_AGX 3
#define VITRINE_TONE_REINHARD 4

#endif
