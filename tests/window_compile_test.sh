#!/bin/bash
# SPDX-License-Identifier: MIT
# With an empty shader cache, a slider is moved to where other programs are needed, and a heavy snippet
# is written while a hand turns the camera: no step of the window waits for the compiler, and the
# picture follows.
#   window_compile_test.sh PROGRAM
scenes=$(cd "$(dirname "$0")/../scenes" && pwd)
. "$(dirname "$0")/window_support.sh"
# What is compiled was never compiled before.
export MESA_SHADER_CACHE_DIR=$folder/cache
start_display

# The limits were chosen before the first run: 0.2 s is the goal; on two cores that compile and draw at
# once, some steps may take twice as long. $1: how often something was compiled behind, at least.
check_times() {
    awk -v least="$1" '$1 == "turn" || $1 == "edit" || $1 == "reload" {
             if ($4 > 200 || $5 > 400) { print "too slow: " $0; bad = 1 }
         }
         $1 == "behind" { behind = $2; longest = $5 }
         END {
             if (behind < least || longest < 200) { print "nothing was compiled"; bad = 1 }
             exit bad
         }' timings.txt || fail "the window waited for the compiler"
}

# ---- glass, of which the scene has none ----
write_scene
start_window scene.toml
shoot
first=$shot
xdotool mousemove 540 61 click 1
sleep 0.3
xdotool type --delay 60 transmission
sleep 0.5
xdotool mousemove 190 440 click 1
sleep 0.5
drag 1 600 237 6 0  # the only slider left
soon 60 shows_other "$first"
changed=$shot
xdotool key ctrl+shift+c
copied() { grep -q '^vitrine render' window.log; }
soon 10 copied
command=$(grep '^vitrine render' window.log | sed "s|^vitrine|'$program'|; s|picture.png|copied.png|")
eval "$command" || fail "the copied command fails: $command"
same copied.png "$changed" || fail "glass is drawn in another way than by: $command"
xdotool key ctrl+z  # or the window asks what is to become of the change
soon 60 shows "$first"
close_window
check_times 2

# ---- a heavy snippet ----
cp -r "$scenes/robot.toml" "$scenes/fields" "$scenes/materials" .
sed -i 's/^samples = .*/samples = 1/' robot.toml
start_window robot.toml --camera figure
shoot
first=$shot
screen before

# Turns the camera all the time, to and fro, until the file `stop` is there.
turn() {
    xdotool mousemove 190 100 mousedown 1
    until [ -e stop ]; do
        for way in 12 -12; do
            for _ in 1 2 3 4; do
                xdotool mousemove_relative -- $way 0
                sleep 0.03
            done
        done
    done
    xdotool mouseup 1
}
turn &
hand=$!
head=fields/robot-head.sdf.glsl
cp $head whole
for width in 0.1 0.2 broken 0.3; do
    sleep 1
    screen "compiling-$width"
    # The head is thicker by so much, or does not compile.
    if [ $width = broken ]; then
        sed 's/\<sdf(vec3 p) {/sdf(vec3 p) { p = lenght(p);/' whole > $head
        soon 60 banner
        screen broken
    else
        sed "s/\<sdf(vec3 p) {/sdf(vec3 p) { p \*= 1.0 - $width;/" whole > $head
        cmp -s whole $head && fail "the snippet is another one"
        soon 60 no_banner
    fi
done
sleep 4
touch stop
wait $hand
screen after
xdotool key Home
"$program" render robot.toml --camera figure -o expected.png --resolution 380x450 || fail "render"
soon 60 shows expected.png
same "$first" expected.png && fail "the edit changes nothing"
close_window

check_times 2
turns=$(awk '$1 == "turn" {print $2}' timings.txt)
[ "$turns" -ge 40 ] || fail "only $turns steps"
echo passed
