#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Checks that includes follow the arrows of docs/architecture.md:  tools/check_layers.sh [ROOT]
# Prints FILE:LINE of each that does not; exits with 1 if there is one.
set -uo pipefail
root=${1:-$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)}
cd "$root" || exit 2
bad=0
report() {
    echo "$1: $2"
    bad=1
}

# What each folder of src/ may include besides itself.
declare -A may=(
    [base]="shared"
    [image]="base"
    [mesh]="base"
    [gltf]="base image mesh"
    [scene]="base image"
    [import]="base image mesh gltf scene"
    [bvh]="base"
    [sdf]="base"
    [pack]="base image mesh scene bvh sdf shared"
    [gpu]="base"
    [frame]="base image scene bvh sdf mesh pack gpu shared"
    [app/session]="base image mesh gltf scene import bvh sdf pack gpu frame"
    [app/viewer]="base image mesh scene import bvh sdf pack gpu frame app/session"
    [app/cli]="base image mesh scene bvh sdf pack frame app/session app/viewer"
)
# Folders of shaders/: includes go only leftwards in this list.
order=(shared lib scene trace shade pass entry)
declare -A rank=()
for i in "${!order[@]}"; do rank[${order[$i]}]=$i; done

while IFS=: read -r file line text; do
    folder=${file#src/}
    folder=${folder%/*}
    target=${text#*\"}
    target=${target%%\"*}
    # A test may borrow a helper of another test.
    [[ $file == *_test.cpp && $target != */* ]] && continue
    case $target in
        ../* | */../*) report "$file:$line" "relative include '$target'"; continue ;;
        app/*/*) layer=${target#app/} layer=app/${layer%%/*} ;;
        *) layer=${target%%/*} ;;
    esac
    [ "$layer" = "$folder" ] && continue
    if [ -z "${may[$folder]+known}" ]; then
        report "$file:$line" "the folder src/$folder is not in the table of layers"
    elif [[ " ${may[$folder]} " != *" $layer "* ]]; then
        report "$file:$line" "src/$folder must not use '$target'"
    fi
done < <(grep -rnE '^ *#include "' src --include='*.cpp' --include='*.hpp')

# Only gpu/ sees OpenGL, only files that read TOML see its library.
while IFS=: read -r file line _; do
    [[ $file == src/gpu/* ]] || report "$file:$line" "only src/gpu may include OpenGL"
done < <(grep -rnE '^ *#include <(epoxy|GL|EGL|GLES)' src)

while IFS=: read -r file line text; do
    from=${file#shaders/}
    from=${from%%/*}
    target=${text#*\"}
    target=${target%%\"*}
    to=${target%%/*}
    [ "$to" = generated ] && continue
    if [ -z "${rank[$to]:-}" ] || [ "${rank[$to]}" -gt "${rank[$from]:--1}" ]; then
        report "$file:$line" "shaders/$from must not use '$target'"
    fi
done < <(grep -rnE '^ *#include "' shaders)

# Derivatives, discard and window coordinates do not exist in compute shaders.
while IFS=: read -r file line _; do
    [[ $file == shaders/entry/* ]] || report "$file:$line" "not in both fragment and compute shaders"
done < <(grep -rnE '\b(dFdx|dFdy|fwidth|discard|gl_FragCoord|layout *\(binding)\b' shaders | grep -v '//.*\b(dFdx|discard)')

exit $bad
