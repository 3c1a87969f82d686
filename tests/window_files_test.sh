#!/bin/bash
# SPDX-License-Identifier: MIT
# Opening, saving under another name, and what is asked before anything is lost:
#   window_files_test.sh PROGRAM
ask_to_close=$(cd "$(dirname "$0")" && pwd)/ask_to_close.py
command -v python3 >/dev/null || { echo "skipped: no python3"; exit 77; }
. "$(dirname "$0")/window_support.sh"
write_scene
mkdir below
sed 's/0.8, 0.1, 0.1/0.1, 0.8, 0.1/' scene.toml > green.toml
start_display
start_window scene.toml
size=380x450
shoot
first=$shot

titled() { xdotool search --name "^$1 - Vitrine$" >/dev/null 2>&1; }
type_name() { # into the field that has the cursor, instead of what stands there
    sleep 0.5
    hold ctrl a
    xdotool type --delay 40 "$1"
    sleep 0.3
    hold Return
}
# A value that is changed by hand.
change() {
    xdotool mousemove 540 61 click 1
    sleep 0.3
    hold ctrl a
    xdotool type --delay 60 exposure
    sleep 0.5
    drag 1 620 113 1 0
    sleep 0.5
    xdotool mousemove 190 440 click 1
    sleep 0.3
}

# ---- another file, by its name ----
xdotool key ctrl+o
type_name no-such-file.toml
sleep 0.5
screen open
titled scene.toml || fail "a file that is not there is opened"
type_name green.toml
soon 20 titled ".*green.toml"
"$program" render green.toml -o green.png --resolution $size || fail "render"
shows green.png || fail "the file is not shown"
[ "$(sed 's|.*/||' state/vitrine/recent | tr '\n' ' ')" = "green.toml scene.toml " ] ||
    fail "recent files: $(cat state/vitrine/recent)"

# ---- changes are lost only by who says so ----
change
shows_other green.png || fail "nothing is changed"
changed=$shot
xdotool key ctrl+q
sleep 0.7
screen quit
hold Escape
sleep 0.3
"$ask_to_close" 190 225 || fail "cannot ask the window to close"
sleep 0.7
screen close
hold Escape
shows "$changed" || fail "the changes are gone"

# ---- the same under another name ----
xdotool key ctrl+shift+s
type_name below/mine
sleep 0.5
screen save
[ -e below/mine.toml ] && fail "a scene is saved where its references lead nowhere"
type_name mine
soon 10 test -s mine.toml
soon 10 titled ".*mine.toml"
cmp -s green.toml <(sed 's/0.8, 0.1, 0.1/0.1, 0.8, 0.1/' before.toml) || fail "the scene before is written to"
diff green.toml mine.toml > changes.txt
[ "$(grep -c '^[<>]' changes.txt)" -eq 1 ] && grep -q '^> exposure = ' changes.txt ||
    fail "more than the change is saved: $(cat changes.txt)"
shows "$changed" || fail "the saved scene looks different"
"$program" render mine.toml -o mine.png --resolution $size || fail "render"
shows mine.png || fail "the file does not look like the window"
sed -i 's/0.1, 0.8, 0.1/0.1, 0.1, 0.8/' mine.toml
soon 20 shows_other "$changed" # it is this file that is looked at now
cp scene.toml kept.toml
xdotool key ctrl+shift+s
type_name kept
sleep 0.7
cmp -s scene.toml kept.toml || fail "a file is overwritten without a question"
hold Return
overwritten() { cmp -s mine.toml kept.toml; }
soon 10 overwritten

# ---- a model or a field becomes a scene ----
xdotool key ctrl+o
type_name ball.sdf.glsl
soon 20 titled ".*ball.sdf.glsl"
shoot
ball=$shot
xdotool key ctrl+shift+s
sleep 0.5
hold Return
soon 10 test -s ball.toml
soon 10 titled ".*ball.toml"
"$program" render ball.toml -o ball.png --resolution $size || fail "render"
same ball.png "$ball" || fail "the scene around the field is not what was shown"

# ---- leaving: saved ----
change
xdotool key ctrl+q
sleep 0.7
hold Return # "Save them"
gone() { ! kill -0 "$window_process" 2>/dev/null; }
for _ in $(seq 200); do gone && break; sleep 0.05; done
gone || fail "the window is still there"
wait "$window_process" || fail "exit code"
window_process=
grep -q '^exposure = ' ball.toml || fail "the change is not saved"

# ---- the start screen ----
"$program" > window.log 2>&1 &
window_process=$!
page() { [ "$(pixel 700 440)" = "14 15 17" ]; }
soon 60 page
drawn() { ls cache/vitrine/scene-*.png >/dev/null 2>&1; }
soon 100 drawn
sleep 1
screen start
before=$(cat state/vitrine/recent)
xdotool mousemove 400 200 click 1
there() { [ "$(pixel 700 10)" = "31 32 34" ]; }
soon 60 there
other() { [ "$(cat state/vitrine/recent)" != "$before" ]; }
soon 60 other
grep -q '/lesson-.*\.toml$' <(head -1 state/vitrine/recent) || fail "opened: $(cat state/vitrine/recent)"
xdotool key ctrl+q
for _ in $(seq 400); do gone && break; sleep 0.05; done
gone || fail "Ctrl+Q does not close the window"
wait "$window_process" || fail "exit code"
window_process=
echo passed
