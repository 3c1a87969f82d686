// SPDX-License-Identifier: MIT
// The fields of the uniform block `frame`, pasted into a GLSL std140 block (scene/frame.glsl) and
// into a C++ struct (pack/frame_block.hpp). Only 16-byte types, so that both lay it out alike.
vec4 cameraEye;      // xyz: world space, metres; w: angle of a pixel, radians
vec4 cameraForward;  // xyz: unit; w: unused
vec4 cameraRight;    // xyz: half of the image plane's width at distance 1; w: its square
vec4 cameraUp;       // xyz: half of the image plane's height at distance 1; w: its square
vec4 lens;           // x: radius, m, 0: a pinhole; y: distance of what is sharp, along the axis, m; z: corners of the opening, 0: round; w: radius, m, by which the filter blurs a sharp picture, 0: it does not
vec4 background[3];  // rgb radiance towards zenith, horizon and nadir
vec4 shading;        // x: time, s; y: throughput below which a path ends; z: AO amount; w: AO reach, m
vec4 display;        // x: exposure factor; y: gamma; z: depth view's scale, m; w: unused
vec4 sky;            // x: factor on the sky picture's texels; y: its turn, parts of a circle; z: its width, texels; w: 1: all of it is sampled as a light
vec4 jitter;         // x, y: offset of the sample from the pixel's centre, pixels; z: supersamples along an edge of a pixel; w: 0
ivec4 image;         // x, y: size in pixels; z: tone map; w: view
ivec4 sampling;      // x: sample; y: samples in all; z: bounce (0: camera ray); w: seed
ivec4 tables;        // first texel in sceneTables of x: instances; y: materials; z: lights; w: parameters
ivec4 skyTree;       // x: first node of the tree to sample the sky by; y: its levels; samples at z: first hits; w: later hits
ivec4 probes;        // x: lights with a size, which come first; rays for ambient light at y: first hits; z: later hits; w: looks through the substance for each light, first hits
ivec4 counts;        // x: lights; y: most marching steps; z: root slot of the scene's tree; w: loop budget
ivec4 quick;         // 1: an approximation is taken; x: one shadow ray for a light with a size; y: taps for the occlusion of fields; z, w: unused
ivec4 path;          // x: mode; y: most bounces; z: split at the first hit; w: first texel of the albedo table
