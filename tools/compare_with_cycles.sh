#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Renders a glTF file under a picture of the sky with Cycles (Debian's package blender) and with
# Vitrine in both modes, and measures how they differ (docs/fidelity.md).
#   tools/compare_with_cycles.sh MODEL.gltf SKY.hdr FOLDER [SIZE [SAMPLES]]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
model=$(realpath "$1") sky=$(realpath "$2") out=$3 size=${4:-480} samples=${5:-64}
mkdir -p "$out"
out=$(realpath "$out")
# A scene sees only its own folder.
rm -rf "$out/model"
cp -r "$(dirname "$model")" "$out/model"
cp "$sky" "$out/"
blender -b --factory-startup -noaudio -P "$root/tools/cycles_scene.py" -- \
    "$model" "$sky" "$out/cycles.exr" "$size" "$samples" "$out/scene.toml" > "$out/blender.log" 2>&1
vitrine=${VITRINE:-$root/vitrine}
"$vitrine" render "$out/scene.toml" -o "$out/reference.exr" -r "${size}x$size" --spp "$samples" --mode reference
"$vitrine" render "$out/scene.toml" -o "$out/hybrid.exr" -r "${size}x$size" --spp "$samples"
for mode in reference hybrid; do
    echo "$mode against Cycles:"
    "$vitrine" compare "$out/$mode.exr" "$out/cycles.exr" -o "$out/$mode-difference.png"
done
