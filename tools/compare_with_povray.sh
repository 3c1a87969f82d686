#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The same three things in POV-Ray and in Vitrine, on one core each: a torus and a gyroid as fields
# (POV-Ray's isosurface), the torus as a mesh; camera rays, hard shadows, one reflection, no
# antialiasing. Says what a million pixels cost beyond what a tiny picture costs, and how far the
# pictures agree (docs/performance.md).
#   tools/compare_with_povray.sh FOLDER [WIDTH [ROUNDS]]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
if ! command -v povray > /dev/null; then
    echo "POV-Ray is missing: apt install povray" >&2
    exit 1
fi
out=$1 width=${2:-640} rounds=${3:-3}
height=$((width * 5 / 8))
mkdir -p "$out"
out=$(realpath "$out")
vitrine=${VITRINE:-$root/vitrine}

# ---- what stands there: a torus of 0.65 and 0.25, 384 x 192 quads as a mesh; a ball of gyroid ----

cat > "$out/torus.sdf.glsl" << 'END'
// bounds[-0.91, -0.26, -0.91,  0.91, 0.26, 0.91]
float sdf(vec3 p) { return length(vec2(length(p.xz) - 0.65, p.y)) - 0.25; }
END
cat > "$out/gyroid.sdf.glsl" << 'END'
// bounds[-0.71, -0.71, -0.71,  0.71, 0.71, 0.71]
float sdf(vec3 p) {
    vec3 q = 9.0 * p;
    float g = abs(sin(q.x) * cos(q.y) + sin(q.y) * cos(q.z) + sin(q.z) * cos(q.x)) - 0.4;
    return max(length(p) - 0.7, g / 15.6);
}
END
declare -A shape=(
    [torus]='sdf = "torus.sdf.glsl"'
    [gyroid]='sdf = "gyroid.sdf.glsl"'
    [mesh]='torus = { radius = 0.65, tube = 0.25, segments = 384, sides = 192 }'
)
declare -A object=(
    [torus]='isosurface { function { sqrt(pow(sqrt(x*x + z*z) - 0.65, 2) + y*y) - 0.25 }
    contained_by { box { <-0.91, -0.26, -0.91>, <0.91, 0.26, 0.91> } } max_gradient 1.0 accuracy 0.0005'
    [gyroid]='isosurface { function { max(sqrt(x*x + y*y + z*z) - 0.7,
        (abs(sin(9*x)*cos(9*y) + sin(9*y)*cos(9*z) + sin(9*z)*cos(9*x)) - 0.4) / 15.6) }
    contained_by { box { -0.71, 0.71 } } max_gradient 1.0 accuracy 0.0005'
    [mesh]='#include "mesh.inc"
    object { Torus'
)

awk -v n=384 -v m=192 'BEGIN {
    pi = 3.14159265358979
    print "#declare Torus = mesh2 { vertex_vectors { " (n + 1) * (m + 1)
    for (i = 0; i <= n; i++) for (j = 0; j <= m; j++) {
        a = 2 * pi * i / n; b = 2 * pi * j / m; r = 0.65 + 0.25 * cos(b)
        printf ",<%.7f,%.7f,%.7f>\n", r * cos(a), 0.25 * sin(b), -r * sin(a)
    }
    print "} normal_vectors { " (n + 1) * (m + 1)
    for (i = 0; i <= n; i++) for (j = 0; j <= m; j++) {
        a = 2 * pi * i / n; b = 2 * pi * j / m
        printf ",<%.7f,%.7f,%.7f>\n", cos(b) * cos(a), sin(b), -cos(b) * sin(a)
    }
    print "} face_indices { " 2 * n * m
    for (i = 0; i < n; i++) for (j = 0; j < m; j++) {
        a = i * (m + 1) + j; b = a + m + 1
        printf ",<%d,%d,%d>,<%d,%d,%d>\n", a, b, b + 1, a, b + 1, a + 1
    }
    print "} }"
}' > "$out/mesh.inc"

# POV-Ray leaves the division by pi out of diffuse reflection, hence the sun of 0.8 pi here.
for name in torus gyroid mesh; do
    cat > "$out/$name.toml" << END
[render]
bounces = 1
samples = 1
ao = 0
threshold = 0
tone_map = "none"
[[camera]]
eye = [0.6, 1.5, 2.6]
target = [0, -0.05, 0]
fov = 36
[environment]
sky = [0.25, 0.3, 0.4]
[[light]]
direction = [-0.6, -1.0, -0.45]
color = [1, 1, 1]
intensity = 2.513274
[material.metal]
base_color = [0.7, 0.6, 0.5]
metallic = 1
roughness = 0
[material.floor]
base_color = [0.5, 0.45, 0.4]
roughness = 1
specular = 0
[shape.thing]
${shape[$name]}
[shape.floor]
plane = { size = [400, 0, 400] }
[[node]]
shape = "thing"
material = "metal"
rotate = [35, 0, 0]
[[node]]
shape = "floor"
material = "floor"
at = [0, -0.8, 0]
END
    cat > "$out/$name.pov" << END
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 2 }
background { rgb <0.25, 0.3, 0.4> }
camera { location <0.6, 1.5, 2.6> right -1.6*x look_at <0, -0.05, 0> angle 2*degrees(atan2(1.6*tan(radians(18)), 1)) }
light_source { <0.6, 1.0, 0.45>*1e4 rgb 0.8 parallel point_at 0 }
plane { y, -0.8 pigment { rgb <0.5, 0.45, 0.4> } finish { ambient rgb <0.25, 0.3, 0.4> diffuse 1 } }
${object[$name]}
    pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection rgb <0.7, 0.6, 0.5> }
    rotate <35, 0, 0> }
END
done

# seconds COMMAND...: processor time.
seconds() {
    local TIMEFORMAT='%U %S'
    { time "$@" > /dev/null 2>> "$out/log"; } 2>&1 | awk '{ print $1 + $2 }'
}
pov() { # NAME WIDTH HEIGHT
    (cd "$out" && povray "+I$1.pov" "+O$1-pov.png" "+W$2" "+H$3" +WT1 -D -A +FN8 File_Gamma=sRGB)
}
ours() {
    LP_NUM_THREADS=1 "$vitrine" render "$out/$1.toml" -r "$2x$3" -o "$out/$1-vitrine.png"
}
median() { sort -g | awk '{ v[NR] = $1 } END { print v[int((NR + 1) / 2)] }'; }

: > "$out/log"
printf '%-8s %22s %22s %8s   %s\n' '' 'POV-Ray, s/Mpixel' 'Vitrine, s/Mpixel' ratio agreement
for name in torus gyroid mesh; do
    ours $name 16 10 > /dev/null 2>> "$out/log"  # fills the driver's cache of programs
    for ((i = 0; i < rounds; i++)); do
        for who in pov ours; do
            tiny=$(seconds $who $name 16 10)
            whole=$(seconds $who $name "$width" "$height")
            awk -v a="$whole" -v b="$tiny" -v n=$((width * height)) \
                'BEGIN { print (a - b) / n * 1e6 }' >> "$out/$name-$who.times"
        done
    done
    theirs=$(median < "$out/$name-pov.times") mine=$(median < "$out/$name-ours.times")
    rm -f "$out/$name-pov.times" "$out/$name-ours.times"
    agreement=$("$vitrine" compare "$out/$name-pov.png" "$out/$name-vitrine.png" | head -2 | tr '\n' ' ') || true
    printf '%-8s %22.3f %22.3f %8.2f   %s\n' $name "$theirs" "$mine" \
        "$(awk -v a="$theirs" -v b="$mine" 'BEGIN { print a / b }')" "$agreement"
done
