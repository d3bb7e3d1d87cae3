#!/bin/sh
# SPDX-License-Identifier: MIT
# The programs of ports/examples compile without a warning and draw the same picture as
# `tidepool render`: the sea in SDL2's window without a display, the others with stand-ins
# for their libraries.  The buoy is tested by tests/host/own_module.sh.
. "$(dirname "$0")/../lib/script.sh"

library=${TP_BUILD:-build/host}/libtidepool.a
program=${TP_PROGRAM:-build/host/tidepool}
examples=ports/examples
stand_ins=tests/host/stand_ins

# Prints the CRC-32 of a command's output.
crc_of()        # COMMAND...
{
    "$@" >"$scratch/raw" && gzip -c "$scratch/raw" | tail -c 8 | od -An -tu1 -N4 |
        awk '{ printf "%02x%02x%02x%02x\n", $4, $3, $2, $1 }'
}
# Frame 30 of the first sea; tests/host/first.ini has the numbers of
# tp_scene_init.
want()          # SIZE OPTION...
{
    size=$1; shift
    "$program" render tests/host/first.ini --texels 16 --rung named --size "$size" --frames 30:30 \
        --hash "$@" | sed 's/.* //'
}
draws() { is "$(crc_of "$@")" "$picture"; }
body()  { sed -n '/^{/,/^}/p' "$1" | grep -c '[a-z]'; }

# -- LVGL's canvas ---------------------------------------------------------------------

check "the canvas compiles against LVGL's declarations" gcc -std=c11 $strict -Iinclude \
    -I$stand_ins $examples/lvgl/canvas.c $stand_ins/lvgl.c "$library" -o "$scratch/lvgl"
picture=$(want 320x240 --format rgb565)
check "it shows picture 30 of the first sea" draws "$scratch/lvgl" 31
refuse "which is another than the one before" draws "$scratch/lvgl" 30
short() { [ "$(body $examples/lvgl/canvas.c)" -le 15 ]; }
check "its functions have no more than 15 lines" short

# -- a TFT by TFT_eSPI or LovyanGFX ----------------------------------------------------

sketch()        # STANDARD DEFINE
{
    g++ -std="$1" $strict "$2" -Iinclude -I$stand_ins $examples/tft/tft.cpp \
        $stand_ins/tft.cpp "$library" -o "$scratch/tft"
}
says()          # TEXT WIDTH HEIGHT: prints an error and draws nothing.
{
    text=$1; shift
    "$scratch/tft" "$@" 1 >/dev/null 2>"$scratch/serial"
    is $? 3 && is "$(cat "$scratch/serial")" "$text"
}
grid="--set grid.vertices=400"
for with in TFT_ESPI LOVYANGFX; do
    for standard in c++11 c++17; do
        on="with $with, $standard,"
        check "$on the sketch compiles" sketch $standard -DUSE_$with
        for size in 320x240 135x240; do
            # shellcheck disable=SC2086
            picture=$(want $size --format rgb565be $grid)
            check "$on a panel of $size shows picture 30" \
                draws "$scratch/tft" "${size%x*}" "${size#*x}" 31
        done
        check "$on the serial port tells what does not fit" says \
            "sea: out of memory: 96832 bytes needed, 90112 available" 480 320
        check "$on and of a panel that is too small" says \
            "sea: picture of 8 x 8 pixels; 16 x 16 to 4096 x 4096 can be drawn" 8 8
    done
done

# -- the sea in a window of SDL2 -------------------------------------------------------

if ! pkg-config --exists sdl2 2>/dev/null; then
    skip "the sea in a window" "libsdl2-dev"
    finish
    exit
fi
export SDL_VIDEODRIVER=dummy SDL_AUDIODRIVER=dummy
# shellcheck disable=SC2046
compile_sea()
{
    gcc -std=c11 -O2 -Wall -Wextra -Wconversion -Wshadow -Werror -Iinclude \
        $examples/sea/sea.c "$library" $(pkg-config --cflags --libs sdl2) \
        -o "$scratch/sea"
}
check "the sea compiles" compile_sea
few() { [ "$(wc -l <$examples/sea/sea.c)" -le 150 ]; }
check "it has no more than 150 lines" few
# The file has 54 bytes before its pixels.
pixels()
{
    timeout 120 "$scratch/sea" "$1" "$scratch/$1.bmp" && tail -c +55 "$scratch/$1.bmp"
}
# Counts pixels: of the buoy's red; of white on the graph's panel, rows 408 to 463 and
# columns 16 to 255 of the picture.  The file begins with the last row, at 18 times 3
# bytes.
red()   { LC_ALL=C grep -oaP '\x28\x3c\xe0' "$scratch/$1.bmp" | wc -l; }
white()
{
    for row in $(seq 16 71); do
        dd if="$scratch/$1.bmp" bs=3 skip=$((18 + row * 640 + 16)) count=240 2>/dev/null
    done | LC_ALL=C grep -oaP '\xff\xff\xff' | wc -l
}
picture=99915296
check "its picture 40 is as it was when this test was written" draws pixels 40
seen() { is "$(red 40)" 265; }
check "the buoy is seen in it" seen
picture=efc397f0
check "so is picture 110" draws pixels 110
hidden() { [ -s "$scratch/110.bmp" ] && is "$(red 110)" 0; }
check "where a crest hides the buoy" hidden
over() { [ "$(white 110)" -ge 240 ]; }
check "but not the graph" over
finish
