#!/bin/sh
# SPDX-License-Identifier: MIT
# Writes a project for a board that is not shipped: program, baked scene, linker script,
# Makefile, CMakeLists.txt and a README with the next steps.
#
#   make new-board CPU=cortex-m0plus DIR=../myboard [NAME=VALUE]...
#
#   CPU      cortex-m0 cortex-m0plus cortex-m3 cortex-m4 cortex-m7 cortex-m33
#   DIR      the new folder; its parent exists, and it is new or empty
#   SCENE    a shipped scene or an .ini file; count-64 by default
#   SIZE     size of the picture, WxH; the glass of the panel by default
#   PANEL    ili9341 st7789 st7789_240x240 st7789_135x240 ssd0323; ili9341 by default
#   PICTURE  options that change the picture; "--texels 64" by default
#   MEMORY   options that change the memory; "--strip 64 --band 16" by default
#   FLASH, RAM   sizes, such as 512K; by default those of a usual chip with the CPU
#
# The program runs in QEMU before anything is filled in.  `ports/new_board.sh --check
# NAME=VALUE...` only checks the values.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
from=$root/ports/new-board

usage()  { sed -n '3,18s/^# \{0,1\}//p' "$root/ports/new_board.sh"; }
refuse() { echo "new-board: $*" >&2; exit 2; }

# -- values -------------------------------------------------------------------------------

# CPU: a usual flash and RAM of a chip, QEMU's machine, its origins of flash and RAM.
cpus='
cortex-m0      256K  128K  mps2-an386  0x00000000  0x20000000
cortex-m0plus  2M    256K  mps2-an386  0x00000000  0x20000000
cortex-m3      512K  128K  mps2-an385  0x00000000  0x20000000
cortex-m4      1M    128K  mps2-an386  0x00000000  0x20000000
cortex-m7      2M    512K  mps2-an500  0x00000000  0x20000000
cortex-m33     2M    512K  mps2-an505  0x10000000  0x38000000
'
# Panel: width, height, pixel format, the glass as a picture.
panels='
ili9341         240  320  rgb565be  320x240
st7789          240  320  rgb565be  320x240
st7789_240x240  240  240  rgb565be  240x240
st7789_135x240  135  240  rgb565be  240x135
ssd0323         128  64   l8        128x64
'
line()  { echo "$1" | awk -v name="$2" '$1 == name'; }          # TABLE NAME
names() { echo "$1" | awk 'NF { printf " %s", $1 }'; }          # TABLE

check_cpu()
{
    [ "$CPU" ] || refuse "CPU is missing; known:$(names "$cpus")"
    set -- $(line "$cpus" "$CPU")
    [ $# = 6 ] || refuse "unknown CPU '$CPU'; known:$(names "$cpus")"
    FLASH=${FLASH:-$2} RAM=${RAM:-$3} machine=$4 flash_at=$5 ram_at=$6
    for size in "$FLASH" "$RAM"; do
        echo "$size" | grep -qx '[1-9][0-9]*[KM]\{0,1\}' ||
            refuse "'$size' is no size of FLASH or RAM: 65536, 64K or 1M"
    done
}

check_picture()
{
    set -- $(line "$panels" "$PANEL")
    [ $# = 5 ] || refuse "unknown PANEL '$PANEL'; known:$(names "$panels")"
    width=$2 height=$3 format=$4
    SIZE=${SIZE:-$5}
    echo "$SIZE" | grep -qx '[1-9][0-9]\{0,4\}x[1-9][0-9]\{0,4\}' ||
        refuse "SIZE is WxH, such as 320x240, not '$SIZE'"
    w=${SIZE%x*} h=${SIZE#*x}
    { [ "$w" -le "$width" ] && [ "$h" -le "$height" ]; } ||
        { [ "$w" -le "$height" ] && [ "$h" -le "$width" ]; } ||
        refuse "SIZE $SIZE is larger than the panel $PANEL, ${width}x$height"
    for words in "$SCENE" "$PICTURE" "$MEMORY"; do
        case $words in *[!A-Za-z0-9\ ._/+,=@:-]*)
            refuse "a character of '$words' cannot stand in scripts" ;;
        esac
    done
}

# Sets the absolute path of the new folder, and from there the paths of checkout and scene.
check_folder()
{
    [ "$DIR" ] || refuse "DIR is missing: the new folder"
    to=$(realpath -m -- "$DIR")
    [ -d "${to%/*}/" ] || refuse "there is no folder ${to%/*}"
    [ ! -e "$to" ] || [ -d "$to" ] || refuse "$DIR is a file"
    [ ! -d "$to" ] || [ -z "$(ls -A -- "$to")" ] || refuse "$DIR is not empty"
    tidepool=$(realpath -m --relative-to="$to" "$root")
    # A scene of a file is named from the new folder too.
    [ ! -f "$SCENE" ] || SCENE=$(realpath -m --relative-to="$to" -- "$SCENE")
    case $tidepool in *[!A-Za-z0-9._/+,@-]*)
        refuse "make cannot build from a path such as '$tidepool': move the checkout" ;;
    esac
}

CPU='' DIR='' SCENE=count-64 SIZE='' PANEL=ili9341 FLASH='' RAM=''
PICTURE='--texels 64' MEMORY='--strip 64 --band 16' only_check=
[ "${1:-}" != --check ] || { only_check=1; shift; }
[ $# -gt 0 ] || { usage; exit; }
for pair; do
    case $pair in
    CPU=* | DIR=* | SCENE=* | SIZE=* | PANEL=* | FLASH=* | RAM=* | PICTURE=* | MEMORY=*)
        name=${pair%%=*} value=${pair#*=}
        eval "$name=\$value" ;;
    *)  refuse "unknown: '$pair'" ;;
    esac
done
check_cpu
check_folder
check_picture
[ ! "$only_check" ] || exit 0

# -- the project --------------------------------------------------------------------------

fill()          # TEMPLATE: prints it with the values in place of their names
{
    sed -e "s|@CPU@|$CPU|g; s|@MACHINE@|$machine|g; s|@TIDEPOOL@|$tidepool|g" \
        -e "s|@FLASH_AT@|$flash_at|g; s|@FLASH@|$FLASH|g" \
        -e "s|@RAM_AT@|$ram_at|g; s|@RAM@|$RAM|g; s|@PANEL@|$PANEL|g" \
        -e "s|@SCENE@|$SCENE|g; s|@SIZE@|$SIZE|g; s|@FORMAT@|$format|g" \
        -e "s|@PICTURE_OPTIONS@|${PICTURE:+ $PICTURE}|g; s|@PICTURE@|$PICTURE|g" \
        -e "s|@MEMORY@|$MEMORY|g" "$1"
}

# Everything is written beside the new folder and moved there at the end.
part=${to%/*}/.new-board.$$
mkdir -- "$part"
trap 'rm -rf -- "$part"' EXIT
trap 'exit 1' INT TERM HUP
for file in "$from"/*; do
    name=${file##*/}
    case $name in
    README.md)  ;;
    *.in)       fill "$file" >"$part/${name%.in}" ;;
    *)          cp -- "$file" "$part" ;;
    esac
done
cp -- "$root/ports/cortex-m/sections.ld" "$part"
chmod +x "$part/scene.sh"
TIDEPOOL='' "$part/scene.sh" bake || refuse "the scene was not baked, nothing is written"
rm -r -- "$part/build"
[ ! -d "$to" ] || rmdir -- "$to"
mv -- "$part" "$to"
echo "$DIR: $SCENE at $SIZE for a $CPU"
echo "next, in that folder: make check; its README.md has all steps"
