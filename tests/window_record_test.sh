#!/bin/bash
# SPDX-License-Identifier: MIT
# Films recorded in the window: how many frames, how fast, how large, and what is in them:
#   window_record_test.sh PROGRAM
for tool in ffmpeg ffprobe; do
    command -v "$tool" >/dev/null || { echo "skipped: no $tool"; exit 77; }
done
. "$(dirname "$0")/window_support.sh"
write_scene
cat scene.toml - > moving.toml <<'SCENE'
[[animation]]
node = "crate"
param = "at"
keys = [[0, [-0.9, 0, 0]], [1, [-0.9, 1.8, 0]], [2, [-0.9, 0, 0]]]
SCENE
start_display
start_window moving.toml
shoot
facts() {
    ffprobe -v error -count_frames -select_streams v -of csv=p=0 \
        -show_entries stream=codec_name,width,height,r_frame_rate,nb_read_frames "$1"
}
# Frame N of a film as a picture.
frame() { ffmpeg -v error -y -i "$1" -vf "select=eq(n\,$2)" -frames:v 1 "$3"; }
# Nearly the same: H.264 keeps colours at half the resolution.
near() { "$program" compare "$1" "$2" --tolerance 24 --fraction 0.004 >/dev/null; }

# ---- two seconds with the camera where a hand has put it ----
drag 1 190 225 12 4
sleep 0.3
xdotool key ctrl+shift+c
soon 10 grep -q '^vitrine render' window.log
camera=$(sed -n 's/^vitrine render .* \(--camera .*\)/\1/p' window.log | tail -1)
xdotool key ctrl+r
sleep 1
screen record
hold Return
sleep 0.5
screen recording
[ -e vitrine-0001.mp4 ] && fail "the film is there before it is whole"
soon 120 test -s vitrine-0001.mp4
[ "$(facts vitrine-0001.mp4)" = "h264,380,450,30/1,60" ] || fail "film: $(facts vitrine-0001.mp4)"
sh -c "'$program' render moving.toml -o frame_####.png --resolution 380x450 --frames 0-40:20 \
    --fps 30 $camera" || fail "render"
for number in 0 20 40; do
    frame vitrine-0001.mp4 $number film.png
    near film.png "$(printf 'frame_%04d.png' $number)" ||
        fail "frame $number is not what render draws"
done
near frame_0000.png frame_0020.png && fail "nothing moves: the test tests nothing"
shows "$shot" && fail "the camera has not moved: the test tests nothing"
[ "$(ls ./*.part* 2>/dev/null)" = "" ] || fail "something is left behind"

# ---- what is stopped leaves nothing ----
xdotool key ctrl+r
sleep 0.5
hold Return
sleep 0.5
there=$(echo vitrine-0002*)
[ "$there" = "vitrine-0002*" ] && fail "no film is being written: $(ls)"
xdotool key Escape
gone_again() { [ "$(echo vitrine-0002.mp4*)" = "vitrine-0002.mp4*" ]; }
soon 20 gone_again

# ---- half a second of another kind, size and rate, of two views ----
xdotool mousemove 190 440 key v
shoot
xdotool key ctrl+r
sleep 0.7
xdotool mousemove 290 263 click 1  # WebM
sleep 0.3
xdotool mousemove 313 237 click 1  # 1280x720
sleep 0.3
xdotool mousemove 184 211 click 1  # 24 frames a second
sleep 0.3
xdotool mousemove 420 185 click --repeat 2 --delay 80 1
sleep 0.3
hold ctrl a
xdotool type --delay 60 0.5
sleep 0.3
screen chosen
hold Return
soon 120 test -s vitrine-0001.webm
[ "$(facts vitrine-0001.webm)" = "vp9,1280,720,24/1,12" ] || fail "film: $(facts vitrine-0001.webm)"
sh -c "'$program' render moving.toml -o left.png --resolution 1280x720 $camera && '$program' render \
    moving.toml -o right.png --resolution 1280x720 --view normal $camera" || fail "render"
frame vitrine-0001.webm 0 film.png
for side in left+0 right+640; do
    convert ${side%+*}.png -crop 640x720+${side#*+}+0 +repage side.png
    convert film.png -crop 640x720+${side#*+}+0 +repage filmed.png
    near filmed.png side.png || fail "the film does not show what is ${side%+*} of the line"
done
xdotool mousemove 190 440 key v
close_window

# ---- a still scene: the camera goes around ----
start_window scene.toml
shoot
xdotool key ctrl+r
sleep 0.5
hold Return
soon 200 test -s vitrine-0002.mp4
[ "$(facts vitrine-0002.mp4)" = "h264,380,450,30/1,180" ] || fail "film: $(facts vitrine-0002.mp4)"
frame vitrine-0002.mp4 45 film.png
"$program" render scene.toml -o quarter.png --resolution 380x450 --set 'camera.front.eye=[4,1,0]' ||
    fail "render"
near film.png quarter.png || fail "a quarter of the turn is not where it should be"
close_window

# ---- an encoder that is missing, or fails, is a sentence and no more ----
real=$program
for trouble in 'PATH=/nowhere' 'ulimit -f 8'; do
    printf '#!/bin/bash\n%s\nexec "%s" "$@"\n' "$trouble" "$real" > vitrine.sh
    chmod +x vitrine.sh
    program=$folder/vitrine.sh
    start_window moving.toml
    program=$real
    sleep 1
    xdotool key ctrl+r
    sleep 0.5
    hold Return
    soon 60 banner
    screen trouble
    left=$(echo vitrine-0003.mp4*)
    [ "$left" = "vitrine-0003.mp4*" ] || fail "left behind: $left"
    close_window
done
echo passed
