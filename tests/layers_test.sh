#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The layers hold, and the check that says so would notice if they did not.
set -uo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
check="$root/tools/check_layers.sh"
"$check" "$root" || exit 1

copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
cp -r "$root/src" "$root/shaders" "$copy"

# plant FILE LINE: the check must name FILE when LINE is added to it.
plant() {
    echo "$2" >> "$copy/$1"
    if found=$("$check" "$copy"); then
        echo "not noticed: '$2' in $1"
        exit 1
    fi
    if ! grep -q "^$1:" <<< "$found"; then
        echo "noticed, but not in $1: $found"
        exit 1
    fi
    cp "$root/$1" "$copy/$1"
}
plant src/scene/scene.cpp '#include "gpu/texture.hpp"'
plant src/bvh/bvh.cpp '#include "sdf/snippet.hpp"'
plant src/sdf/emit.cpp '#include "bvh/bvh.hpp"'
plant src/gpu/program.cpp '#include "scene/scene.hpp"'
plant src/pack/assets.cpp '#include "gpu/context.hpp"'
plant src/base/text.cpp '#include "../scene/scene.hpp"'
plant src/frame/frame.cpp '#include "app/session/session.hpp"'
plant src/app/cli/render.cpp '#include <epoxy/gl.h>'
plant shaders/lib/math.glsl '#include "scene/frame.glsl"'
plant shaders/trace/node.glsl '#include "shade/path.glsl"'
plant shaders/pass/light.glsl 'float planted() { return dFdx(1.0); }'
"$check" "$copy" || exit 1

# And the build itself refuses: the include does not even compile.
includes=${1:?the include folder of a build}
echo '#include "gpu/texture.hpp"' > "$copy/planted.cpp"
if c++ -std=c++20 -fsyntax-only -I"$includes/scene" -I"$includes/base" "$copy/planted.cpp" 2> /dev/null; then
    echo "a scene file can include gpu/texture.hpp"
    exit 1
fi
c++ -std=c++20 -fsyntax-only -I"$includes/gpu" -I"$includes/base" "$copy/planted.cpp" || exit 1
