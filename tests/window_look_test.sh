#!/bin/bash
# SPDX-License-Identifier: MIT
# The window shows what `render` draws, follows the hand, and rests:
#   window_look_test.sh PROGRAM
. "$(dirname "$0")/window_support.sh"
write_scene
start_display
start_window scene.toml

# ---- what is shown is what `render` draws ----
shoot
first=$shot
cp "$shot" first.png
screen start
size=$(identify -format '%wx%h' "$first")
[ "$size" = 380x450 ] || fail "the picture is $size"
"$program" render scene.toml -o rendered.png --resolution "$size" || fail "render"
same rendered.png "$first" || fail "the window shows another picture than render draws"

# ---- the camera ----
drag 1 100 200 15 4
shows_other "$first" || fail "a drag does not turn the camera"
turned=$shot
screen turned
xdotool key ctrl+shift+c
copied() { grep -q '^vitrine render' window.log; }
soon 10 copied
command=$(grep '^vitrine render' window.log | sed "s|^vitrine|'$program'|; s|picture.png|copied.png|")
eval "$command" || fail "the copied command fails: $command"
same copied.png "$turned" || fail "the copied command draws another picture: $command"
xdotool key Home
shows "$first" || fail "Home does not bring the camera back"
drag 3 100 200 10 10
shows_other "$first" || fail "a right drag does not move the camera"
xdotool key 1
shows "$first" || fail "1 does not go to the first camera"
xdotool mousemove 150 180 click 4 click 4
shows_other "$first" || fail "the wheel does not move the camera"
xdotool key 2
shoot
"$program" render scene.toml -o side.png --resolution "$size" --camera side || fail "render"
same side.png "$shot" || fail "2 does not go to the second camera"
xdotool key 1 keydown w sleep 0.3 keyup w
shows_other "$first" || fail "W does not walk"
xdotool key Home
shows "$first" || fail "Home does not bring the camera back"
# The crate is red; seen from near it fills the middle.
xdotool mousemove 98 237 key f
shoot
red() { set -- $(convert "$shot[1x1+190+225]" -depth 8 txt:- |
    sed -n 's/.*(\([0-9]*\),\([0-9]*\),\([0-9]*\).*/\1 \2 \3/p'); [ "$1" -gt $((2 * $2)) ]; }
red || fail "F does not fly to the crate under the cursor"
xdotool key Home
shows "$first" || fail "Home does not bring the camera back"

# ---- help, and the window without its panel ----
quiet=$(pixel 190 225)
xdotool mousemove 190 440 key h
differs() { [ "$(pixel 190 225)" != "$quiet" ]; }
soon 10 differs
screen help
xdotool key h
gone() { [ "$(pixel 190 225)" = "$quiet" ]; }
soon 10 gone
xdotool key Tab
shoot
[ "$(identify -format '%wx%h' "$shot")" = 720x450 ] || fail "Tab does not hide the panel"
xdotool key Tab
shows "$first" || fail "Tab does not bring the panel back"

# ---- two views side by side ----
"$program" render scene.toml -o normal.png --resolution "$size" --view normal || fail "render"
convert normal.png -crop 160x360+210+40 +repage right.png
convert first.png -crop 160x360+10+40 +repage left.png
xdotool mousemove 190 225 key v
soon 20 side right.png 210
soon 20 side left.png 10
screen split
shoot # both halves, as they are seen
convert "$shot" -crop 160x360+210+40 +repage half.png
same right.png half.png || fail "F12 does not write what is right of the line"
convert "$shot" -crop 160x360+10+40 +repage half.png
same left.png half.png || fail "F12 does not write what is left of the line"
drag 1 190 225 -36 0  # the line, to x = 10
convert normal.png -crop 160x360+30+40 +repage most.png
soon 20 side most.png 30
xdotool mousemove 300 225 key v
convert first.png -crop 160x360+30+40 +repage most.png
soon 20 side most.png 30

# ---- a view that counts, by the menu ----
"$program" render scene.toml -o nodes.png --resolution "$size" --view nodes || fail "render"
show() { # entry of the menu at y
    xdotool mousemove 581 10 click 1
    sleep 0.5
    xdotool mousemove 581 "$1"
    sleep 0.3
    xdotool click 1
    sleep 0.3
    xdotool mousemove 190 440
}
show 298
shows nodes.png || fail "the menu does not show the nodes"
screen views
show 38
shows "$first" || fail "the menu does not show the colours again"

# ---- nothing moves, nothing is done ----
sleep 4.5  # the message of the written picture goes
begin=$(ticks)
sleep 5
used=$(($(ticks) - begin))
echo "idle: $used of $((5 * $(getconf CLK_TCK))) ticks"
[ $used -le $((5 * $(getconf CLK_TCK) * 2 / 100)) ] || fail "busy although the picture is finished"

close_window
echo passed
