#!/bin/bash
# SPDX-License-Identifier: MIT
# The camera as a body: walls of both kinds stop it, flights go over them; paths of the scene play
# and are taken over:
#   window_walk_test.sh PROGRAM
. "$(dirname "$0")/window_support.sh"

cat > wall.sdf.glsl <<'FIELD'
// bounds[-0.2, -1.5, -5,  0.2, 1.5, 5]
float sdf(vec3 p) { vec3 d = abs(p) - vec3(0.1, 1.4, 4.9); return min(max(d.x, max(d.y, d.z)), 0.0) + length(max(d, 0.0)); }
FIELD
cat > scene.toml <<'SCENE'
[render]
ao = 0
[[camera]]
name = "front"
eye = [0, 1.6, 4]
target = [0, 1.2, 0]
[[camera]]
name = "behind"
eye = [0, 1, -3]
target = [0, 1, 0]
[[camera]]
name = "path"
eye = [-2, 1, 4]
target = [0, 1, 0]
[[light]]
direction = [-1, -2, -1]
[material.red]
base_color = [0.8, 0.1, 0.1]
[shape.floor]
plane = { size = 30 }
[shape.wall]
box = { size = [9, 2.2, 0.1] }
[shape.field]
sdf = "wall.sdf.glsl"
[[node]]
name = "floor"
shape = "floor"
[[node]]
name = "wall"
shape = "wall"
material = "red"
at = [0, 1.1, 0]
[[node]]
name = "field"
shape = "field"
at = [2, 1.5, 3]
[[animation]]
camera = "path"
param = "eye"
keys = [[0, [-2, 1, 4]], [3, [2, 1, 4]]]
loop = "repeat"
SCENE
start_display
start_window scene.toml
shoot
sleep 1

# Where the eye is, by the command that the window copies: "X Y Z" in `eye`.
eyes=0
look() {
    eyes=$((eyes + 1))
    xdotool key ctrl+shift+c
    copied() { [ "$(grep -c '^vitrine render' window.log)" -ge $eyes ]; }
    soon 10 copied
    eye=$(grep '^vitrine render' window.log | sed -n "${eyes}p" |
        sed -n 's/.*eye=\[\([^]]*\)\].*/\1/p' | tr ',' ' ')
}
# Whether the eye is where awk says it of x, y and z.
eye_is() { echo "$eye" | awk "{x = \$1; y = \$2; z = \$3; exit !($1)}"; }

# ---- who lets go of Ctrl before S does not walk ----
# A slow frame finds all that at once.
for slow in false true; do
    xdotool mousemove 190 440
    sleep 0.3
    $slow && kill -STOP $window_process
    xdotool keydown ctrl keydown s keyup ctrl
    $slow && kill -CONT $window_process
    sleep 0.4
    xdotool keyup s
    look
    eye_is 'z == 4' || fail "Ctrl+S walks to $eye"
done

# ---- a wall of triangles in front, a wall that is a field at the right ----
xdotool mousemove 190 440
# Holds a key until the camera stands still: a slow machine takes small steps.
walk_on() {
    local last=
    xdotool keydown shift keydown "$1"
    sleep 1
    look
    for _ in $(seq 20); do
        [ "$eye" = "$last" ] && break
        last=$eye
        sleep 0.5
        look
    done
    xdotool keyup "$1" keyup shift
    sleep 0.3
}
walk_on w
screen wall
look
eye_is 'z > 0.25 && z < 0.34 && y > 1.59 && y < 1.61' || fail "W ends at $eye, not before the wall"
walk_on d
look
screen field
eye_is 'x > 1.55 && x < 1.69 && z < 0.34' || fail "D ends at $eye, not before the field"
xdotool key b keydown w
through() { look; eye_is 'z < 0'; }
soon 10 through
xdotool keyup w
eye_is 'z < 0' || fail "B does not let the camera through the wall: $eye"
xdotool key b

# ---- a flight to the other side goes over the wall ----
xdotool key Home
sleep 1.5
look
eye_is 'z == 4 && y > 1.59 && y < 1.61' || fail "Home goes to $eye"
shoot
xdotool key 2
highest=0
for _ in $(seq 12); do
    look
    highest=$(echo "$eye $highest" | awk '{print ($2 > $4 ? $2 : $4)}')
    sleep 0.05
done
sleep 1
look
eye_is 'z == -3' || fail "2 flies to $eye"
echo "highest: $highest"
echo "$highest" | awk '{exit !($1 > 2.2)}' || fail "the flight goes through the wall at $highest"

# ---- the camera on a path plays, is taken over, and is given back ----
on_path='y == 1 && z == 4'
xdotool key 3
sleep 2.2
look
eye_is "$on_path && x > -2 && x < 2" || fail "the path does not play: $eye"
drag 1 100 200 15 8
sleep 0.4
look
taken=$eye
eye_is "!($on_path)" || fail "a drag does not take the camera over: $eye"
sleep 0.4
look
[ "$eye" = "$taken" ] || fail "the camera goes on although a hand has it: $taken, $eye"
xdotool key Home
sleep 2
look
before=$eye
eye_is "$on_path" || fail "Home does not give the camera back to the path: $eye"
sleep 0.4
look
eye_is "$on_path" || fail "the camera leaves its path: $eye"
[ "$eye" != "$before" ] || fail "the time does not go on"
xdotool key space

close_window

# ---- a turntable turns from the beginning; a screen is looked at squarely ----
cat > gallery.toml <<'SCENE'
[render]
ao = 0
[[camera]]
name = "turntable"
eye = [0, 1, 5]
target = [0, 1, 0]
orbit = { period = 6 }
[[camera]]
name = "door"
eye = [2, 1.6, 4]
target = [0, 1, 0]
[shape.sheet]
plane = { size = [1.6, 0, 0.9] }
[shape.crate]
box = { size = 0.5 }
[material.red]
base_color = [0.8, 0.1, 0.1]
[[node]]
name = "screen"
shape = "sheet"
material = "red"
at = [0, 1, 0]
rotate = [90, 20, 0]
[[node]]
name = "crate"
shape = "crate"
at = [0, 0.25, -1]
SCENE
eyes=0
start_window gallery.toml
sleep 1
look
eye_is 'y > 0.99 && y < 1.01 && x * x + z * z > 24.9 && x * x + z * z < 25.1 && z < 4.99' ||
    fail "the turntable does not turn: $eye"
drag 1 100 200 8 0
sleep 0.5
look
taken=$eye
sleep 0.4
look
[ "$eye" = "$taken" ] || fail "the turntable goes on although a hand has it: $taken, $eye"
shoot  # nothing is left that moves
xdotool key 2
sleep 1.5
xdotool mousemove 190 225 key f
sleep 1.2
look
screen square
# 36 mm beside a focal length of 35 mm see 1.6 m and a margin of 4 % from 1.618 m: along the sheet's
# normal (sin 20, 0, cos 20).
eye_is 'x > 0.543 && x < 0.563 && y > 0.99 && y < 1.01 && z > 1.51 && z < 1.53' ||
    fail "F ends at $eye, not square in front of the screen"
red() { set -- $(pixel "$1" "$2"); [ "$1" -gt $((2 * $2)) ]; }
red 12 225 && red 367 225 || fail "the screen does not fill the view"
red 3 225 && fail "the screen is cut off"
close_window
echo passed
