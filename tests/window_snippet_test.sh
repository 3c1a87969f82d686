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
    size=large
}

# The resident memory in kB of the finished picture, when nothing is left to do.
memory_at_rest() {
    mend
    soon 20 at_rest
    memory_now=$(awk '/^VmRSS/ {print $2}' "/proc/$window_process/status")
}

: > latencies
before_memory=
size=large
for i in $(seq "$times"); do
    begin=$(now)
    case $((i % 6)) in
        3) kind=broken; echo "${ball/length(p)/lenght(p)}" > ball.sdf.glsl; soon 20 banner ;;
        0) kind=cut; echo "${ball:0:$((${#ball} - 4 - i % 7))}" > ball.sdf.glsl; soon 20 banner ;;
        *)
            kind=good
            # A smaller ball, then a large one again: the pixel is beside one and in the other. Each
            # time another text, that the driver cannot have compiled before.
            if [ "$size" = large ]; then size=small radius="0.4$i * radius"; else
                size=large radius="1.0$i * radius"; fi
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
# A sketch of a changed field, without its shadow, comes before all of it is compiled.
for i in 1 2 3 4 5; do
    soon 20 at_rest
    begin=$(now)
    echo "${ball/- radius/- 0.5${i}1 * radius}" > ball.sdf.glsl
    other() { [ "$(pixel 230 225)" != "$was" ]; }
    was=$(pixel 230 225)
    soon 20 other
    echo "sketch $(($(now) - begin))" >> latencies
    shoot
    echo "whole $(($(now) - begin))" >> latencies
    mend
done
for kind in good broken cut sketch whole; do
    grep "^$kind" latencies | sort -k2n | awk -v kind=$kind '{ms[NR] = $2}
        END {printf "%-7s %3d times  median %5d ms  longest %5d ms\n", kind, NR,
             ms[int((NR + 1) / 2)], ms[NR]}' | tee "median_$kind"
done
median() { awk '{print $5}' "median_$1"; }
[ $(($(median sketch) * 3)) -le $(($(median whole) * 2)) ] || fail "no sketch comes first"
echo "memory: $before_memory kB after 23, $after_memory kB after $times edits"
[ $((after_memory * 100)) -le $((before_memory * 105)) ] || fail "memory grows"
close_window
echo passed
