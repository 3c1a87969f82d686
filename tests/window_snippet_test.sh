#!/bin/bash
# SPDX-License-Identifier: MIT
# A snippet is written fifty times while the window shows it, every third time broken or cut short:
#   window_snippet_test.sh PROGRAM [TIMES]
# Prints how long each kind took to show; the memory of the finished picture stays within 5 %.
. "$(dirname "$0")/window_support.sh"
times=${2:-50}
# Several arenas of the allocator keep more or less of what is free, by chance; with one, what grows is
# a leak.
export MALLOC_ARENA_MAX=1
write_scene
start_display
start_window scene.toml
shoot
first=$shot

now() { date +%s%3N; }

# The snippet as it was, and the whole picture of it.
mend() {
    echo "$ball" > ball.sdf.glsl
    soon 20 no_banner
    soon 20 shows "$first"
    radius=radius
}

# The resident memory in kB of the finished picture, when nothing is left to do.
memory_at_rest() {
    mend
    soon 20 at_rest
    memory_now=$(awk '/^VmRSS/ {print $2}' "/proc/$window_process/status")
}

: > latencies
before_memory=
radius=radius
for i in $(seq "$times"); do
    begin=$(now)
    case $((i % 6)) in
        3) kind=broken; echo "${ball/length(p)/lenght(p)}" > ball.sdf.glsl; soon 20 banner ;;
        0) kind=cut; echo "${ball:0:$((${#ball} - 4 - i % 7))}" > ball.sdf.glsl; soon 20 banner ;;
        *)
            kind=good
            # A smaller ball, then the whole one again: the pixel is beside one and in the other.
            if [ "$radius" = radius ]; then radius='0.4 * radius'; else radius=radius; fi
            was=$(pixel 230 225)
            echo "${ball/- radius/- $radius}" > ball.sdf.glsl
            other() { [ "$(pixel 230 225)" != "$was" ] && no_banner; }
            soon 20 other
            ;;
    esac
    echo "$kind $(($(now) - begin))" >> latencies
    # The first ones fill the caches of the driver, and so do the first mistakes and their mending.
    [ "$i" -eq 23 ] && memory_at_rest && before_memory=$memory_now
done
memory_at_rest
after_memory=$memory_now
for kind in good broken cut; do
    grep "^$kind" latencies | sort -k2n | awk -v kind=$kind '{ms[NR] = $2}
        END {printf "%-7s %3d times  median %5d ms  longest %5d ms\n", kind, NR,
             ms[int((NR + 1) / 2)], ms[NR]}'
done
echo "memory: $before_memory kB after 23, $after_memory kB after $times edits"
[ $((after_memory * 100)) -le $((before_memory * 105)) ] || fail "memory grows"
close_window
echo passed
