#!/bin/bash
# SPDX-License-Identifier: MIT
# Values changed in the window and files changed behind it:
#   window_change_test.sh PROGRAM
. "$(dirname "$0")/window_support.sh"
write_scene
start_display
start_window scene.toml
shoot
first=$shot

# ---- a value is dragged and undone; saved, it changes one line ----
search() {
    xdotool mousemove 540 61 click 1
    sleep 0.3
    hold ctrl a
    xdotool type --delay 60 "$1"
    sleep 0.3
    xdotool mousemove 190 440 click 1  # out of the text field
    sleep 0.3
}
search 'exposure'
screen panel
slider_y=113
drag 1 620 $slider_y 1 0
shows_other "$first" || fail "the slider changes nothing"
changed=$shot
# Beside it, as it was.
convert "$changed" -crop 160x360+10+40 +repage left.png
convert "$first" -crop 160x360+210+40 +repage right.png
xdotool mousemove 190 440 key shift+v
soon 20 side right.png 210
soon 20 side left.png 10
screen before
xdotool key shift+v
shows "$changed" || fail "the comparison does not go"
xdotool key ctrl+z
shows "$first" || fail "undo does not bring the picture back"
xdotool key ctrl+y
shows "$changed" || fail "redo does not bring the change back"
# Typed: Ctrl and a click turn a slider into a field.
xdotool mousemove 620 $slider_y keydown ctrl click 1 keyup ctrl
sleep 0.3
hold ctrl a
xdotool type --delay 60 "2.5"
sleep 0.2
hold Return
sleep 0.2
xdotool mousemove 190 440
"$program" render scene.toml -o typed.png --resolution 380x450 --set render.exposure=2.5 ||
    fail "render"
shows typed.png || fail "a typed value is not the value that is drawn"
screen typed
xdotool key ctrl+s
written() { ! cmp -s scene.toml before.toml; }
soon 10 written
diff before.toml scene.toml > changes.txt
cat changes.txt
[ "$(grep -c '^[<>]' changes.txt)" -eq 1 ] || fail "a save changes more than a line"
grep -q '^> exposure = 2.5' changes.txt || fail "the value is not in the file"
shows typed.png || fail "the saved scene looks different"

# ---- a click selects what is under the cursor, in the panel too ----
search 'base_color'
xdotool mousemove 98 237 click 1
sleep 0.5
screen selected

# ---- a broken snippet stands over the last good picture until it is mended ----
quiet=$(pixel 4 4)
echo "${ball/length(p)/lenght(p)}" > ball.sdf.glsl
soon 20 banner
[ "$(pixel 98 237)" != "0 0 0" ] || fail "the last good picture is gone"
screen error
echo "${ball/return/retur}" > ball.sdf.glsl
sleep 1
banner || fail "another mistake is not shown"
echo "$ball" > ball.sdf.glsl
clear() { [ "$(pixel 4 4)" = "$quiet" ]; }
soon 20 clear
shows typed.png || fail "the mended scene looks different"
echo "${ball/- radius/- radius * 1.5}" > ball.sdf.glsl
soon 20 shows_other typed.png
rm ball.sdf.glsl
soon 20 banner
echo "$ball" > ball.sdf.glsl
soon 20 no_banner
soon 20 shows typed.png

# ---- so does a scene that is written half ----
head -c 200 scene.toml > half.toml
cp scene.toml whole.toml
cp half.toml scene.toml
soon 20 banner
cp whole.toml scene.toml
soon 20 no_banner
shows typed.png || fail "the scene looks different when it is whole again"
cp before.toml scene.toml
soon 20 shows "$first"

close_window
echo passed
