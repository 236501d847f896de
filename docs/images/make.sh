#!/bin/sh
# Makes the pictures of README.md anew. Needs ImageMagick.
set -eu
cd "$(dirname "$0")"
cga=../../cga
for view in rear front side; do "$cga" render --samples 4 --camera "$view" --out "motorcycle-$view.png"; done
"$cga" render --samples 4 --size 400x225 --frames 36 --fps 12 --mouse 900 --drive "W 1, WA 0.6, W 1.4" --out drive.apng

strip=$(mktemp -d)
trap 'rm -rf "$strip"' EXIT
for step in 4.1 4.2 4.3 4.3.4 4.4 4.5 4.6 4.7; do
    mouse=0
    if [ "$step" = 4.5 ]; then mouse=500; fi
    "$cga" render --samples 4 --size 480x270 --step "$step" --mouse "$mouse" --out "$strip/$step.png"
done
montage -background '#111' -fill '#ddd' -pointsize 15 \
    -label '4.1 emission' "$strip/4.1.png" -label '4.2 point light' "$strip/4.2.png" \
    -label '4.3 spotlight' "$strip/4.3.png" -label '4.3.4 attenuation' "$strip/4.3.4.png" \
    -label '4.4 colour' "$strip/4.4.png" -label '4.5 orbit' "$strip/4.5.png" \
    -label '4.6 corner lights' "$strip/4.6.png" -label '4.7 Blinn-Phong' "$strip/4.7.png" \
    -tile 4x2 -geometry +4+4 -strip steps.png

# A case of the golden report: highlights that are too wide. Needs Chromium.
home=$strip/home
mkdir -p "$home/tests"
cp -R ../../shaders ../../assets "$home"
cp -R ../../tests/golden "$home/tests"
sed -i 's/material.shininess)/0.5 * material.shininess)/' "$home/shaders/lighting.glsl"
java -Dcga.home="$home" -cp '../../build/cga/lib/*' cga.cli.MainKt golden --only step-4.6 --report "$strip/report.html" || [ $? = 1 ]
chromium --headless --no-sandbox --hide-scrollbars --window-size=1240,1275 --screenshot="$strip/report.png" "file://$strip/report.html"
convert "$strip/report.png" -strip -crop 1240x1005+0+250 +repage -resize 1000x report.png
