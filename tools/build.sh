#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs what is missing, configures and builds:  tools/build.sh PRESET [TARGET...]
# Says nothing when there is nothing to do. All output goes to standard error.
set -euo pipefail
exec 1>&2
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
preset=$1
shift

install_packages() {
    local wanted stamp missing sudo=""
    wanted=$(grep -v '^#' "$root/tools/packages.txt")
    stamp="$root/build/.packages-$(cksum < "$root/tools/packages.txt" | cut -d' ' -f1)"
    [ -e "$stamp" ] && return
    if command -v dpkg-query > /dev/null; then
        missing=$(for package in $wanted; do
            dpkg-query -W -f='${Status}' "$package" 2> /dev/null | grep -q 'install ok installed' || echo "$package"
        done)
        if [ -n "$missing" ]; then
            [ "$(id -u)" = 0 ] || sudo=sudo
            echo "vitrine: installing" $missing
            export DEBIAN_FRONTEND=noninteractive
            $sudo apt-get update -qq
            $sudo apt-get install -y -qq --no-install-recommends $missing > /dev/null
        fi
    else
        echo "vitrine: no dpkg here; make sure that these exist:" $wanted
    fi
    mkdir -p "$root/build"
    touch "$stamp"
}

install_packages
cd "$root"
folder="build/$preset"
targets=()
for target in "$@"; do targets+=(--target "$target"); done
if [ ! -e "$folder/build.ninja" ]; then
    echo "vitrine: building ($preset); this takes a few minutes the first time"
    cmake --preset "$preset" > "build/$preset.log" 2>&1 || { cat "build/$preset.log"; exit 1; }
fi
# A no-op build is silent; otherwise ninja's own progress is shown if somebody is watching.
if [ -t 2 ]; then
    NINJA_STATUS="[%f/%t] " cmake --build "$folder" "${targets[@]}" | grep --line-buffered -v 'no work to do' || [ "${PIPESTATUS[0]}" = 0 ]
else
    cmake --build "$folder" "${targets[@]}" > "build/$preset.log" 2>&1 || { grep -E 'error|FAILED|Error' -A5 "build/$preset.log" || cat "build/$preset.log"; exit 1; }
fi
