#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Draws the pictures of README.md and docs/ anew. Needs ImageMagick for the sheets.
#   tools/make_pictures.sh [NAME...]    lesson views tank case; all of them without a name
# VITRINE names another program than ./vitrine.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
wanted=" ${*:-lesson views tank case} "

# sheet FILE COLUMNS: all pictures of $work, each with its name, without its number, under it.
sheet() {
    local pictures=() picture
    for picture in "$work"/*.png; do
        pictures+=(-label "$(basename "$picture" .png | sed 's/^[0-9]* //')" "$picture")
    done
    montage -pointsize 15 -fill '#333' "${pictures[@]}" -tile "$2x" -geometry +5+5 \
        -background white "PNG24:$1"
    rm -f "$work"/*.png
}

if [[ $wanted == *" lesson "* ]]; then
    ${VITRINE:-./vitrine} render scenes/lesson-both.toml -o docs/lesson-both.png -r 960x540 --spp 64
fi
if [[ $wanted == *" views "* ]]; then
    for view in normal instance barycentric steps shadow reflection; do
        ${VITRINE:-./vitrine} render scenes/lesson-both.toml -o "$work/$view.png" -r 400x240 --spp 8 --view $view
    done
    sheet docs/views.png 3
fi
if [[ $wanted == *" tank "* ]]; then
    # Every stage on the way, in the order in which the frame takes them.
    n=10
    for view in instance primitive barycentric depth albedo normal material ao direct shadow \
        reflection nodes loops bvh=0 bvh=4 bvh=8; do
        ${VITRINE:-./vitrine} render scenes/tank.toml -o "$work/$n $view.png" -r 320x200 --spp 8 --view $view
        n=$((n + 1))
    done
    ${VITRINE:-./vitrine} render scenes/tank.toml -o "$work/$n light of one bounce.png" -r 320x200 --spp 16 \
        --set render.bounces=1
    ${VITRINE:-./vitrine} render scenes/tank.toml -o "$work/$((n + 1)) light of four bounces.png" -r 320x200 \
        --spp 16 --set render.bounces=4
    sheet docs/tank-views.png 3
fi
if [[ $wanted == *" case "* ]]; then
    ${VITRINE:-./vitrine} render scenes/vitrine-case.toml -o docs/vitrine-case.png -r 960x600 --spp 64
fi
