#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Draws the pictures of docs/sdf.md and docs/patterns.md anew with Vitrine itself:
#   tools/make_sdf_pages.sh [sdf/sdBox patterns/patBricks ...]
# Needs a build in build/dev, and ImageMagick to make the files small. The pages' text is written by
#   VITRINE_UPDATE_DOCS=1 build/dev/tools/sdf_pages_test
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=${VITRINE_BUILD:-build/dev}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p docs/sdf docs/patterns

all=$("$build/tools/make_sdf_pages" "$work")
[ $# -gt 0 ] && names=("$@") || mapfile -t names <<< "$all"
for name in "${names[@]}"; do
    "$build/vitrine" render "$work/$name.toml" -o "$work/$name.png" -r 160x120 --spp 8 > "$work/log" ||
        { cat "$work/log"; exit 1; }
    # A palette of 96 colours: a third of the bytes, and nobody sees it at this size.
    convert "$work/$name.png" -dither None -colors 96 -strip \
        -define png:compression-level=9 "PNG8:docs/$name.png"
done
