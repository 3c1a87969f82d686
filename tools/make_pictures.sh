#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Draws the pictures of README.md and docs/ anew. Needs ImageMagick for the sheets.
#   tools/make_pictures.sh [NAME...]    lesson views tank case robot window; all of them without a name
# VITRINE names another program than ./vitrine. The window needs Xvfb and xdotool.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
wanted=" ${*:-lesson views tank case robot window} "

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
if [[ $wanted == *" robot "* ]]; then
    ${VITRINE:-./vitrine} render scenes/robot.toml -o docs/robot.png -r 960x540 --spp 32
    # Both ends of each parameter; they must differ by more than 0.3 % on average.
    n=10
    while read -r key low high camera; do
        pair=()
        for value in "$low" "$high"; do
            pair+=("$work/$n ${key#material.}=${value//[\[\]]/}.png")  # ImageMagick reads [...] as a part
            ${VITRINE:-./vitrine} render scenes/robot.toml -o "${pair[-1]}" -r 240x180 --spp 16 --camera "${camera:-portrait}" \
                --set "$key=$value"
            n=$((n + 1))
        done
        difference=$(compare -metric MAE "${pair[@]}" null: 2>&1 | sed 's/.*(\(.*\))/\1/') || true
        awk "BEGIN { exit !($difference > 0.003) }" || {
            echo "make_pictures: $key changes only $difference of the picture" >&2
            exit 1
        }
    done <<'PARAMETERS'
light.key.polar 0 90
light.key.azimuth -60 90
light.key.color [1,0.45,0.15] [0.2,0.5,1]
camera.focal_length 20 200
camera.face.f_stop 1 22 face
camera.focus_distance 2.5 20
render.exposure_percent 25 400
render.gamma 0.5 2
render.ao 0 5 body
render.sss_all 0 1 body
material.shell.base_color [0.9,0.55,0.02] [0.03,0.1,0.7]
PARAMETERS
    sheet docs/robot-parameters.png 4
    mogrify +dither -colors 256 -define png:format=png8 docs/robot-parameters.png
fi
if [[ $wanted == *" window "* ]]; then
    program=$(readlink -f "${VITRINE:-./vitrine}") root=$PWD
    Xvfb -displayfd 5 -screen 0 1280x760x24 5> "$work/display" > /dev/null 2>&1 &
    server=$!
    until [ -s "$work/display" ]; do sleep 0.1; done
    DISPLAY=:$(cat "$work/display")
    export DISPLAY XDG_STATE_HOME=$work XDG_CACHE_HOME=$work
    cd "$work"
    "$program" view "$root/scenes/robot.toml" -r 1280x760 &
    sleep 20
    xdotool key F12  # writes the picture when it is finished
    until [ -s vitrine-0001.png ]; do sleep 1; done
    xdotool mousemove 440 320 click 1  # the head
    sleep 6                            # until the message of the picture is gone
    import -window root "PNG24:$root/docs/window.png"
    xdotool key ctrl+q
    wait %2 || true
    kill $server
    rm -f "$work"/*.png
fi
