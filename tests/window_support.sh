# SPDX-License-Identifier: MIT
# What the tests of the window share: a virtual display, the window on scene.toml, real events of
# mouse and keys, and looks at pictures. Sourced with the program's name in $1; makes a folder of its
# own and goes there. Exits with 77 (skipped) where Xvfb, xdotool or ImageMagick are missing.
set -u
program=$1
for tool in Xvfb xdotool import; do
    command -v "$tool" >/dev/null || { echo "skipped: no $tool"; exit 77; }
done

folder=$(mktemp -d)
kept=${VITRINE_WINDOW_SHOTS:-}  # a folder that gets the pictures of the screen
window_process=
server=
finish() {
    [ -n "$window_process" ] && kill "$window_process" 2>/dev/null
    [ -n "$server" ] && kill "$server" 2>/dev/null && wait "$server" 2>/dev/null
    rm -rf "$folder"
}
trap finish EXIT
failure=$PWD/failed_$(basename "$0" .sh).png  # what was to be seen when the test failed
cd "$folder" || exit 1
# What the window remembers of its user is not looked at, nor written to.
export XDG_STATE_HOME=$folder/state XDG_CACHE_HOME=$folder/cache
export PYTHONDONTWRITEBYTECODE=1  # next to the sources

fail() {
    echo "FAILED: $*"
    [ -e window.log ] && cat window.log
    import -window root "$failure" 2>/dev/null
    exit 1
}

# Keeps a picture of the whole screen, if somebody wants to look at it.
screen() { [ -z "$kept" ] || import -window root "$kept/$1.png"; }

# Tries a command for some seconds.
soon() {
    local end=$((SECONDS + $1)) seconds=$1
    shift
    until "$@"; do
        [ $SECONDS -ge $end ] && fail "not within $seconds s: $*"
        kill -0 "$window_process" 2>/dev/null || fail "the window is gone"
        sleep 0.05
    done
}

write_ball() { # the whole snippet, or a broken one
    ball='// bounds[-1, -1, -1,  1, 1, 1]
uniform float radius;  // slider[0.1, 0.5, 1.0] Radius
float sdf(vec3 p) { return length(p) - radius; }'
    echo "$ball" > ball.sdf.glsl
}

write_scene() {
    write_ball
    cat > scene.toml <<'SCENE'
# Comments stay.
[render]
samples = 1
ao = 0.5   # half
[[camera]]
name = "front"
eye = [0, 1, 4]
target = [0, 0, 0]
[[camera]]
name = "side"
eye = [4, 1, 0.5]
target = [0, 0, 0]
focal_length = 50
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
}

# A server that ends can take the socket of a new one of the same number with it: then another.
start_display() {
    for _ in 1 2 3 4 5; do
        : > display
        Xvfb -displayfd 5 -screen 0 720x450x24 5> display >/dev/null 2>&1 &
        server=$!
        for _ in $(seq 200); do [ -s display ] && break; sleep 0.05; done
        DISPLAY=:$(cat display)
        export DISPLAY
        xdotool getmouselocation >/dev/null 2>&1 && return
        kill "$server" 2>/dev/null
        wait "$server" 2>/dev/null
    done
    fail "no display"
}

# Any further arguments go to the program. The window fills the screen; the panel takes 340 pixels.
start_window() {
    "$program" view -r 720x450 --timings timings.txt "$@" > window.log 2>&1 &
    window_process=$!
    # The bar of menus stands there as soon as the scene has been read.
    there() { [ "$(pixel 700 10)" = "31 32 34" ]; }
    soon 60 there
}

# Ctrl+Q ends it, with success and a table of the times that it took to answer.
close_window() {
    xdotool key ctrl+q
    gone() { ! kill -0 "$window_process" 2>/dev/null; }
    for _ in $(seq 200); do gone && break; sleep 0.05; done
    gone || fail "Ctrl+Q does not close the window"
    wait "$window_process"
    local code=$?
    window_process=
    [ $code -eq 0 ] || fail "exit code $code"
    cat timings.txt
}

shots=0
# The finished picture, by F12, in the variable `shot`.
shoot() {
    shots=$((shots + 1))
    shot=$(printf 'vitrine-%04d.png' $shots)
    xdotool key F12
    soon 60 test -s "$shot"
}
same() { "$program" compare "$1" "$2" --tolerance 2 --fraction 0.001 >/dev/null; }
shows() { shoot && same "$1" "$shot"; }
shows_other() { shoot && ! same "$1" "$shot"; }
# Whether a part of the screen at x $2, 160x360 pixels, is the picture $1.
side() {
    import -window root -crop "160x360+$2+40" +repage -depth 8 screen.png && same "$1" screen.png
}
# The colour of a pixel of the screen as "R G B".
pixel() {
    import -window root -crop "1x1+$1+$2" -depth 8 txt:- |
        sed -n 's/.*(\([0-9]*\),\([0-9]*\),\([0-9]*\).*/\1 \2 \3/p' | tail -1
}
# Drags with a button from a point, five times by an offset. As slowly as a hand: ImGui 1.86 asks
# once a frame where the mouse is, and a press within a long frame is one where the mouse went.
drag() {
    xdotool mousemove "$2" "$3" mousedown "$1"
    sleep 0.15
    for _ in 1 2 3 4 5; do xdotool mousemove_relative -- "$4" "$5"; sleep 0.03; done
    xdotool mouseup "$1"
}
# Presses keys together for as long as a finger would: ImGui asks for keys once a frame.
hold() {
    local key
    for key in "$@"; do xdotool keydown "$key"; done
    sleep 0.3
    for key in "$@"; do xdotool keyup "$key"; done
    sleep 0.1
}
# Whether the band of an error stands over the picture.
banner() { set -- $(pixel 4 4); [ "$1" -gt $(($2 + 40)) ] && [ "$1" -gt $(($3 + 40)) ]; }
no_banner() { ! banner; }
# The processor time that the window has taken, in hundredths of a second.
ticks() { awk '{print $14 + $15}' "/proc/$window_process/stat"; }
# Whether the window had nothing to do for half a second.
at_rest() {
    local before
    before=$(ticks)
    sleep 0.5
    [ $(($(ticks) - before)) -le 1 ]
}
