#!/bin/bash
# SPDX-License-Identifier: MIT
# Hands on the objects: handles, undo, the tree with its eyes:
#   window_hands_test.sh PROGRAM
. "$(dirname "$0")/window_support.sh"
write_scene
start_display
start_window scene.toml
size=380x450
shoot
first=$shot

# ---- the arrow x moves the crate along x, as `--set` does; undone, redone, saved ----
xdotool mousemove 75 250 click 1
sleep 0.5
screen selected
shows "$first" || fail "selecting changes the picture"
xdotool mousemove 150 225
sleep 0.3
drag 1 150 225 10 3
shows_other "$first" || fail "the arrow moves nothing"
moved=$shot
screen moved
xdotool key ctrl+z
shows "$first" || fail "a drag is not one step of undo"
xdotool key ctrl+y
shows "$moved" || fail "redo does not bring the move back"
save() { # the value of the key $1 as it is in the file now
    cp scene.toml last.toml
    xdotool key ctrl+s
    written() { ! cmp -s scene.toml last.toml; }
    soon 10 written
    value=$(diff last.toml scene.toml | sed -n "s/^> $1 = //p")
    [ -n "$value" ] || fail "no $1 in $(diff last.toml scene.toml)"
    echo "$1 = $value"
}
save at
[ "$(diff before.toml scene.toml | grep -c '^[<>]')" -eq 2 ] || fail "a save changes more than a line"
# 50 pixels: 0.555 m at the crate's distance.
echo "$value" | awk -F'[][, ]+' '{exit !($2 > -0.38 && $2 < -0.31 && $3 == 0 && $4 == 0)}' ||
    fail "the crate has gone to $value"
"$program" render before.toml -o moved.png --resolution $size --set "node.crate.at=$value" ||
    fail "render"
same moved.png "$moved" || fail "a move by hand is not what --set does"

# ---- Esc gives a drag up ----
xdotool mousemove 205 225
sleep 0.3
xdotool mousedown 1
for _ in 1 2 3; do xdotool mousemove_relative 12 0; sleep 0.1; done
shows_other "$moved" || fail "the arrow does not follow while it is dragged"
hold Escape
xdotool mousemove_relative 12 0
sleep 0.1
xdotool mouseup 1
shows "$moved" || fail "Esc does not give the drag up"

# ---- turned and scaled in steps with Ctrl ----
snapping() { # drags from a point
    xdotool mousemove "$1" "$2"
    sleep 0.4
    xdotool keydown ctrl
    drag 1 "$1" "$2" "$3" "$4"
    xdotool keyup ctrl
    sleep 0.3
}
xdotool mousemove 190 440 key r
sleep 0.4
screen turn
snapping 158 146 8 2  # the top of the ring around z, which is seen from its front
screen turned
save rotate
echo "$value" | awk -F'[][, ]+' '{z = $4 / 15; exit !($2 == 0 && $3 == 0 && z < 0 && z == int(z))}' ||
    fail "the crate is turned by $value"
"$program" render scene.toml -o turned.png --resolution $size || fail "render"
shows turned.png || fail "the turned crate looks different when it is rendered"
xdotool mousemove 190 440 key t
sleep 0.4
snapping 159 226 6 -6  # the cube in the middle
screen scaled
save scale
echo "$value" | awk '{s = $1 * 10; d = s - int(s + 0.5); exit !(s > 10 && d * d < 1e-6)}' ||
    fail "the crate is scaled by $value"
shows_other turned.png || fail "scaling changes nothing"

# ---- the tree: hidden, shown, flown to ----
shoot
whole=$shot
"$program" render scene.toml -o hidden.png --resolution $size --set node.ball.visible=false ||
    fail "render"
xdotool mousemove 398 130 click 1
soon 20 shows hidden.png # a click takes a frame longer than a key
screen hidden
xdotool mousemove 398 130 click 1
soon 20 shows "$whole"
xdotool mousemove 440 130 click 1
sleep 0.3
screen ball
xdotool mousemove 440 110 click --repeat 2 --delay 80 1
soon 20 shows_other "$whole"
red() { set -- $(convert "$shot[1x1+190+225]" -depth 8 txt:- |
    sed -n 's/.*(\([0-9]*\),\([0-9]*\),\([0-9]*\).*/\1 \2 \3/p'); [ "$1" -gt $((2 * $2)) ]; }
red || fail "a double click in the tree does not fly to the crate"
screen visited

close_window
echo passed
