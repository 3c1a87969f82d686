#!/bin/bash
# SPDX-License-Identifier: MIT
# What is shown over the picture on demand:
#   window_tools_test.sh PROGRAM
. "$(dirname "$0")/window_support.sh"
write_scene
start_display
start_window scene.toml

# A part of the screen, 200x160 from a corner, as it is and as it was.
part() { import -window root -crop "200x160+$1+$2" +repage "$3"; }
becomes() { part "$1" "$2" now.png && same "$3" now.png; }
becomes_other() { part "$1" "$2" now.png && ! same "$3" now.png; }

# ---- what is under the cursor ----
xdotool mousemove 98 237
shoot # only when the picture is finished does nothing else change
sleep 0.5
part 0 250 empty.png
xdotool key i
soon 40 becomes_other 0 250 empty.png
shoot
sleep 0.5
part 0 250 crate.png
screen inspector
xdotool mousemove 280 225
soon 40 becomes_other 0 250 crate.png
xdotool mousemove 98 237
soon 40 becomes 0 250 crate.png
xdotool key i
soon 40 becomes 0 250 empty.png

# ---- milliseconds by pass ----
shoot # the frame that counts has gone, too
sleep 0.5
part 0 40 empty.png
xdotool key g
soon 60 becomes_other 0 40 empty.png
sleep 0.5
screen passes
xdotool key g
soon 60 becomes 0 40 empty.png

close_window
echo passed
