#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Draws the pictures of README.md and docs/ anew. Needs ImageMagick for the sheet of views.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

./vitrine render scenes/lesson-both.toml -o docs/lesson-both.png -r 960x540 --spp 64
sheet=()
for view in normal instance barycentric steps shadow reflection; do
    ./vitrine render scenes/lesson-both.toml -o "$work/$view.png" -r 400x240 --spp 8 --view $view
    sheet+=("$work/$view.png")
done
montage "${sheet[@]}" -tile 3x -geometry 400x240+4+4 -background white PNG24:docs/views.png
