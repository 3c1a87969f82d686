#!/bin/bash
# SPDX-License-Identifier: MIT
# Files dropped on the window are opened, or refused with a reason:
#   window_drop_test.sh PROGRAM
drop=$(cd "$(dirname "$0")" && pwd)/drop_file.py
command -v python3 >/dev/null || { echo "skipped: no python3"; exit 77; }
. "$(dirname "$0")/window_support.sh"
write_scene
mkdir "other place"
sed 's/0.8, 0.1, 0.1/0.1, 0.8, 0.1/; s/size = 0.8/size = 1.1/' scene.toml > "other place/green.toml"
cp ball.sdf.glsl "other place"
echo 'neither a scene nor a model' > notes.txt
echo '[render' > broken.toml
start_display
start_window scene.toml
size=380x450
shoot
first=$shot
dropped() {
    "$drop" 190 225 "$@"
    case $? in
        0) ;;
        77) echo "skipped: no libX11"; exit 77 ;;
        *) fail "the window does not take $*" ;;
    esac
}

dropped notes.txt
soon 10 banner
screen refused
shows "$first" || fail "a file of an unknown kind changes the picture"
dropped broken.toml
soon 10 banner
shows "$first" || fail "a broken scene changes the picture"
"$program" render "other place/green.toml" -o green.png --resolution $size || fail "render"
dropped "other place/green.toml" notes.txt
soon 10 no_banner
shows green.png || fail "the dropped scene is not shown"
screen opened
"$program" render ball.sdf.glsl -o ball.png --resolution $size || fail "render"
dropped ball.sdf.glsl
shows ball.png || fail "the dropped field is not shown"

close_window
echo passed
