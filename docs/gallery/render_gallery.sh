#!/usr/bin/env bash
# Renew the pictures of docs/gallery.md:  docs/gallery/render_gallery.sh [DRT_RENDER] [NAME...]
#
# DRT_RENDER is the program (default: the one on the PATH). With names (glossy-classic, carousel ...) only those pictures.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
scenes=$here/../../scenes
size=320x240
program=${1:-drt-render}
shift || true
wanted=" $* "

# render PICTURE SCENE [OPTION...]
render() {
    local picture=$1 scene=$2
    shift 2
    [[ $wanted == "  " || $wanted == *" $picture "* ]] || return 0
    echo "$picture"
    "$program" "$scenes/$scene" --quiet --resolution "$size" "$@" -o "$here/$picture.png"
}

# render_sheet PICTURE SCENE FIRST LAST: frames FIRST to LAST, four in a row, small (oiiotool)
render_sheet() {
    local picture=$1 scene=$2 first=$3 last=$4
    [[ $wanted == "  " || $wanted == *" $picture "* ]] || return 0
    echo "$picture"
    local frames
    frames=$(mktemp -d)
    "$program" "$scenes/$scene" --quiet --resolution 160x120 --spp 32 --frames "$first-$last" -o "$frames/####.png"
    oiiotool "$frames"/*.png --mosaic:pad=2 "4x$(((last - first + 4) / 4))" -o "$here/$picture.png"
    rm -r "$frames"
}

for effect in glossy translucency shadows focus motion combined; do
    for method in classic distributed; do
        render "$effect-$method" "$effect-$method.yaml"
    done
done
for scene in room textures billiard; do
    render "$scene" "$scene.yaml"
done
for frame in 0 20 39 50; do
    render "camera-move-$frame" camera-move.yaml --frame "$frame"
done
for frame in 0 8 16 24; do
    render "turn-$frame" turn.yaml --frame "$frame"
done
for frame in 0 2 4 7; do
    render "bounce-$frame" bounce.yaml --frame "$frame"
done
for frame in 2 4 6 9; do
    render "dominoes-$frame" dominoes.yaml --frame "$frame"
done
render heavy-on-light heavy-on-light.yaml --frame 13
render_sheet break break.yaml 0 15
render still-life legacy/still-life.txt
render carousel legacy/carousel.txt --frame 10
render manual-example legacy/manual-example.txt --frame 4
render manual-example-lit legacy/manual-example-lit.txt --frame 4
size=400x300
render hero combined-distributed.yaml
