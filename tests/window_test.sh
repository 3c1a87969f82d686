#!/bin/bash
# SPDX-License-Identifier: MIT
# The window under a virtual display, driven by real events of mouse and keys:
#   window_test.sh PROGRAM
# Exits with 77 (skipped) where Xvfb, xdotool or ImageMagick are missing.
set -u
program=$1
for tool in Xvfb xdotool import; do
    command -v "$tool" >/dev/null || { echo "skipped: no $tool"; exit 77; }
done

folder=$(mktemp -d)
window_process=
server=
finish() {
    [ -n "$window_process" ] && kill "$window_process" 2>/dev/null
    [ -n "$server" ] && kill "$server" 2>/dev/null
    rm -rf "$folder"
}
trap finish EXIT
cd "$folder" || exit 1

fail() {
    echo "FAILED: $*"
    cat window.log
    exit 1
}

# Tries a command for some seconds.
soon() {
    local seconds=$1 end=$((SECONDS + $1))
    shift
    until "$@"; do
        [ $SECONDS -ge $end ] && fail "not within $seconds s: $*"
        kill -0 "$window_process" 2>/dev/null || fail "the window is gone"
        sleep 0.1
    done
}

ball='// bounds[-1, -1, -1,  1, 1, 1]
uniform float radius;  // slider[0.1, 0.5, 1.0] Radius
float sdf(vec3 p) { return length(p) - radius; }'
echo "$ball" > ball.sdf.glsl
cat > scene.toml <<'SCENE'
# Comments stay.
[render]
samples = 1
ao = 0.5   # half
[[camera]]
name = "front"
eye = [0, 1, 4]
target = [0, 0, 0]
[[light]]
direction = [-1, -2, -1]
[material.red]
base_color = [0.8, 0.1, 0.1]
[shape.crate]
box = { size = 0.8 }
[shape.ball]
sdf = "ball.sdf.glsl"
[[node]]
name = "crate"
shape = "crate"
material = "red"
at = [-0.9, 0, 0]
[[node]]
name = "ball"
shape = "ball"
at = [0.8, 0, 0]
SCENE
cp scene.toml before.toml

exec 5> display
Xvfb -displayfd 5 -screen 0 1280x800x24 >/dev/null 2>&1 &
server=$!
for _ in $(seq 100); do [ -s display ] && break; sleep 0.1; done
DISPLAY=:$(cat display)
export DISPLAY
"$program" view scene.toml > window.log 2>&1 &
window_process=$!

there() { xdotool search --name Vitrine >/dev/null 2>&1; }
soon 60 there

shots=0
# The finished picture, by F12, in the variable `shot`.
shoot() {
    shots=$((shots + 1))
    shot=$(printf 'vitrine-%04d.png' $shots)
    xdotool key F12
    soon 60 test -s "$shot"
}
same() { "$program" compare "$1" "$2" --tolerance 2 --fraction 0.001 >/dev/null; }
# The colour of a pixel of the screen as "R G B".
pixel() {
    import -window root -crop "1x1+$1+$2" -depth 8 txt:- |
        sed -n 's/.*(\([0-9]*\),\([0-9]*\),\([0-9]*\).*/\1 \2 \3/p' | tail -1
}
ticks() { awk '{print $14 + $15}' "/proc/$window_process/stat"; }

# ---- what is shown is what `render` draws ----
shoot
first=$shot
size=$(identify -format '%wx%h' "$first")
"$program" render scene.toml -o rendered.png --resolution "$size" || fail "render"
same rendered.png "$first" || fail "the window shows another picture than render draws"

# ---- nothing moves, nothing is done ----
sleep 6
begin=$(ticks)
sleep 4
used=$(($(ticks) - begin))
echo "idle: $used ticks of $(getconf CLK_TCK) in 4 s"
[ $used -le $((4 * $(getconf CLK_TCK) * 2 / 100)) ] || fail "busy although the picture is finished"

# ---- the camera ----
drag() { # button, from x y, by x y
    xdotool mousemove "$2" "$3" mousedown "$1"
    for _ in 1 2 3 4 5; do xdotool mousemove_relative -- "$4" "$5"; sleep 0.05; done
    xdotool mouseup "$1"
}
drag 1 200 300 20 5
sleep 1
shoot
same "$first" "$shot" && fail "a drag does not turn the camera"
xdotool key Home
sleep 2
shoot
same "$first" "$shot" || fail "Home does not bring the camera back"
drag 3 200 300 10 10
sleep 1
shoot
same "$first" "$shot" && fail "a right drag does not move the camera"
xdotool key 1
sleep 2
shoot
same "$first" "$shot" || fail "1 does not go to the first camera"
xdotool mousemove 300 250 click 4 click 4
sleep 1
shoot
same "$first" "$shot" && fail "the wheel does not move the camera"
xdotool key Home
sleep 2

# ---- a value is dragged and undone; saved, it changes one line ----
search() {
    xdotool mousemove 1100 54 click 1
    sleep 0.5
    xdotool key ctrl+a
    sleep 0.3
    xdotool type --delay 100 "$1"
    sleep 0.5
    xdotool mousemove 450 650 click 1  # out of the text field
    sleep 0.5
}
search 'exposure'
slider_y=101
drag 1 1173 $slider_y 1 0
sleep 1
shoot
changed=$shot
same "$first" "$changed" && fail "the slider changes nothing"
xdotool key ctrl+z
sleep 1
shoot
same "$first" "$shot" || fail "undo does not bring the picture back"
xdotool key ctrl+y
sleep 0.5
xdotool key ctrl+s
written() { ! cmp -s scene.toml before.toml; }
soon 10 written
diff before.toml scene.toml > changes.txt
cat changes.txt
[ "$(grep -c '^[<>]' changes.txt)" -eq 1 ] || fail "a save changes more than a line"
grep -q '^> exposure = ' changes.txt || fail "the value is not in the file"
sleep 2
shoot
same "$changed" "$shot" || fail "the saved scene looks different"

# ---- a broken snippet stands over the last good picture until it is mended ----
quiet=$(pixel 4 4)
echo "${ball/length(p)/lenght(p)}" > ball.sdf.glsl
red() { set -- $(pixel 4 4); [ "$1" -gt $(($2 + 40)) ] && [ "$1" -gt $(($3 + 40)) ]; }
soon 20 red
[ "$(pixel 200 500)" != "0 0 0" ] || fail "the last good picture is gone"
echo "${ball/return/retur}" > ball.sdf.glsl
sleep 1
red || fail "another mistake is not shown"
echo "$ball" > ball.sdf.glsl
clear() { [ "$(pixel 4 4)" = "$quiet" ]; }
soon 20 clear
shoot
same "$changed" "$shot" || fail "the mended scene looks different"
echo "${ball/- radius/- radius * 1.5}" > ball.sdf.glsl
sleep 2
shoot
same "$changed" "$shot" && fail "a changed snippet is not shown"

# ---- it closes ----
xdotool key ctrl+q
gone() { ! kill -0 "$window_process" 2>/dev/null; }
for _ in $(seq 50); do gone && break; sleep 0.1; done
gone || fail "Ctrl+Q does not close the window"
wait "$window_process"
code=$?
window_process=
[ $code -eq 0 ] || fail "exit code $code"
echo passed
