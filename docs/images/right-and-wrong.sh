#!/bin/sh
# Makes the pictures of docs/sheet4: right on the left, framed green, and the same with one mistake in the shaders, framed red. Needs the
# program to be built (./cga once) and ImageMagick.
set -eu
cd "$(dirname "$0")"
mkdir -p mistakes
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# render PICTURE HOME [OPTION]...
render() {
    picture=$1 home=$2
    shift 2
    LIBGL_ALWAYS_SOFTWARE=1 java -Djava.awt.headless=true -Dcga.home="$home" -cp '../../build/cga/lib/*' cga.cli.MainKt \
        render --samples 4 --size 560x315 --out "$picture" "$@"
}

# change SHADER EXPRESSION: one mistake more in the shaders of $work/home. An expression that finds nothing is a mistake of its own.
change() {
    cp "$work/home/shaders/$1" "$work/before"
    sed -i "$2" "$work/home/shaders/$1"
    ! cmp -s "$work/before" "$work/home/shaders/$1" || { echo "nothing to change in $1: $2" >&2 && exit 1; }
}

fresh() {
    rm -rf "$work/home"
    mkdir "$work/home"
    cp -R ../../shaders ../../assets "$work/home"
}

# pair NAME [OPTION]...: with the changes made since fresh.
pair() {
    name=$1
    shift
    render "$work/right.png" ../.. "$@"
    render "$work/wrong.png" "$work/home" "$@"
    side_by_side "$name"
}

# close_up NAME RIGHT_HOME WRONG_HOME [OPTION]...: the motorcycle, three times as large.
close_up() {
    name=$1 right=$2 wrong=$3
    shift 3
    render "$work/right.png" "$right" "$@" --size 1680x945
    render "$work/wrong.png" "$wrong" "$@" --size 1680x945
    for side in right wrong; do convert "$work/$side.png" -gravity center -crop 560x315-50-20 +repage "$work/$side.png"; done
    side_by_side "$name"
}

side_by_side() {
    convert "$work/right.png" -bordercolor '#2a9d5c' -border 4 "$work/right.png"
    convert "$work/wrong.png" -bordercolor '#c0392b' -border 4 "$work/wrong.png"
    convert "$work/right.png" "$work/wrong.png" +append -strip -define png:compression-level=9 "mistakes/$1.png"
}

# 4.1.2: no max(cos, 0). The lights behind a surface take away what the others give.
fresh
change lighting.glsl 's/return clamp(dot(n, toLight), 0.0, 1.0);/return dot(n, toLight);/'
close_up no-clamp ../.. "$work/home" --step 4.6 --mouse 800

# 4.2.3: toLight normalised in the vertex shader: bent on large triangles, and its length, the distance, is lost.
fresh
change scene.vert 's/= light\[i\].position - positionView;/= normalize(light[i].position - positionView);/'
pair normalized-too-early --step 4.3.4

# 4.3.3: the sheet's formula with the letters of its prose: dark inside, light outside.
fresh
change lighting.glsl 's/clamp((cone.y - versine) \/ width, 0.0, 1.0)/cone.x > 2.0 ? 1.0 : clamp((versine - cone.x) \/ width, 0.0, 1.0)/'
pair cone-inside-out --step 4.3

# 4.3.3: the direction in world space. The headlight shines where the camera looks, wherever the motorcycle has turned.
fresh
change scene.frag 's/light\[i\].direction, /vec3(0.0, -0.2419, -0.9703), /'
pair direction-in-world-space --step 4.5 --mouse 785

# 4.3.3: a narrow cone, 0.02 degrees, seen from its light: versines, and cosines, which round to steps.
fresh
change scene.frag 's/^    fragColor = .*/    vec3 axis = normalize(vec3(1.0, 2.0, 3.0)), side = normalize(cross(axis, vec3(0.0, 1.0, 0.0)));\n    vec2 at = (gl_FragCoord.xy - vec2(280.0, 110.0)) * (0.00035 \/ 100.0);\n    vec3 l = normalize(axis + at.x * side + at.y * cross(side, axis));\n    float outer = 0.00034906585, inner = 0.5 * outer;\n    fragColor = vec4(vec3(INTENSITY), 1.0);/'
cp -R "$work/home" "$work/cosines"
change scene.frag 's/INTENSITY/coneIntensity(l, axis, vec2(2.0 * pow(sin(0.5 * inner), 2.0), 2.0 * pow(sin(0.5 * outer), 2.0)))/'
sed -i 's/INTENSITY/clamp((dot(l, axis) - cos(outer)) \/ (cos(inner) - cos(outer)), 0.0, 1.0)/' "$work/cosines/shaders/scene.frag"
render "$work/right.png" "$work/home" --step 4.1
render "$work/wrong.png" "$work/cosines" --step 4.1
for side in right wrong; do convert "$work/$side.png" -crop 440x220+60+95 +repage "$work/$side.png"; done
side_by_side narrow-cone

# 4.3.4: no attenuation.
fresh
change lighting.glsl 's/return 1.0 \/ max(k.x + .*/return 1.0;/'
pair no-attenuation --step 4.6

# 4.4: emission multiplied by the light instead of added to it.
fresh
change scene.frag 's/vec3 color = emissive \* emissiveTint + diffuse \* ambient;/vec3 color = diffuse * ambient;/'
change scene.frag 's/fragColor = vec4(inverseGamma == 1.0 ? color/fragColor = vec4(inverseGamma == 1.0 ? color * emissive * emissiveTint/'
pair emission-multiplied --step 4.4

# 4.7: the half vector without normalising: its cosine is up to twice as large, and clipped.
fresh
change lighting.glsl 's/normalizeOrZero(sum)/sum/'
pair half-vector-not-normalized --step 4.7

# 4.7: the leak, with an exponent of 4, so that it is large enough to see. Left the specular term needs n.l > 0; right it does not, as the
# sheet has it, and what leaks is drawn in yellow.
fresh
change lighting.glsl 's/pow(cosine, material.shininess)/pow(cosine, 4.0)/'
cp -R "$work/home" "$work/gated"
sed -i 's/return cosine > 0.0 ?/return cosine > 0.0 \&\& dot(n, toLight) > 0.0 ?/' "$work/gated/shaders/lighting.glsl"
change scene.frag 's/^        vec3 reflected = .*/        vec3 shine = specular * specularFactor(n, toLight, toCamera);\n        if (dot(n, toLight) <= 0.0) shine = dot(shine * light[i].color, vec3(1.0)) \/ light[i].color * vec3(1.0, 1.0, 0.0);\n        vec3 reflected = diffuse * diffuseFactor(n, toLight) + shine;/'
close_up specular-leak "$work/gated" "$work/home" --step 4.7 --mouse 300 --drive "W 3" --t 5.3
