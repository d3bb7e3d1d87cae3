#!/bin/sh
# SPDX-License-Identifier: MIT
# A Raspberry Pi Pico, emulated by the npm package rp2040js: the boot ROM accepts the image,
# both cores draw, and the panel shows the host's pictures.  An image for a Pico 2 is what
# its boot ROM needs.  The project for the Pico SDK is compiled against stand-ins; with
# PICO_SDK_PATH set, registers are compared with that SDK's headers.
#
#   tests/boards/pico.sh [PROGRAM]
#   tests/boards/pico.sh --write            measures the board's rows of configurations.csv
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/flash.sh"
. "$(dirname "$0")/../lib/rows.sh"

write=
[ "${1:-}" != --write ] || { write=1; shift; }
program=${TP_PROGRAM:-${1:-build/host/tidepool}}
scene=count-64@64
measured="count-64@64 count-64+cheap@64 lava@64 tarn@64 minimal@64"      # scenes of --write
here=tests/boards/pico
client=build/tests/pico                 # the package is installed here
image=build/pico/scenes/$scene

# -- the project for the SDK -----------------------------------------------------------

# Each header of the SDK is the stand-in.
sdk_compiles()
{
    mkdir -p "$scratch/pico" "$scratch/hardware"
    for header in pico/stdlib pico/multicore pico/mutex hardware/dma hardware/spi; do
        echo '#include "tests/boards/sdk/pico_project.h"' >"$scratch/$header.h"
    done
    cc -std=c11 -Wall -Wextra -Wconversion -Wno-unused-function -Werror -I"$scratch" \
        -Iinclude -Iports -I. -c ports/pico/sdk/main.c -o "$scratch/sdk.o"
}
check "the project for the SDK compiles against stand-ins" sdk_compiles
sdk_files()     # files that the CMake project names exist; scene.c is baked
{
    sed -n 's,.*${root}/\([a-z0-9/]*\.c\).*,\1,p' ports/pico/sdk/CMakeLists.txt |
        tr ' ' '\n' >"$scratch/named"
    [ -s "$scratch/named" ] && while read -r file; do [ -f "$file" ] || return 1; done \
        <"$scratch/named"
}
check "its files exist" sdk_files

lacks arm-none-eabi-gcc gcc-arm-none-eabi "the Raspberry Pi Pico" && { finish; exit; }

# -- the program -----------------------------------------------------------------------

check "the program builds, as UF2 too" alone build -s BOARD=pico SCENE=$scene elf uf2
[ "$failed" = 0 ] || { finish; exit; }

check "so does the program for a Pico 2" \
    alone build -s BOARD=pico/pico2 SCENE=$scene elf uf2
other_build()   # OPTION: main.c with another number of cores
{
    arm-none-eabi-gcc -std=c11 -mcpu=cortex-m0plus -mthumb -ffreestanding -Wall -Wextra \
        -Werror -Iinclude -Iports -Isrc "$@" -fsyntax-only ports/pico/main.c
}
check "it compiles for one core" other_build -DPICO_CORES=1

for tool in node=nodejs npm=npm; do
    lacks "${tool%=*}" "${tool#*=}" "the Raspberry Pi Pico, emulated" && { finish; exit; }
done
check "the emulator is installed" $here/install.sh $client

uf2_holds()     # UF2 IMAGE FAMILY: the blocks of the file hold the image
{
    node -e '
const fs = require("fs"), family = parseInt(process.argv[3], 16);
const [uf2, image] = process.argv.slice(1, 3).map(f => fs.readFileSync(f));
const pages = [];
for (let at = 0; at < uf2.length; at += 512)
    if (uf2.readUInt32LE(at) === 0x0a324655 && uf2.readUInt32LE(at + 508) === 0x0ab16f30
            && uf2.readUInt32LE(at + 12) === 0x10000000 + at / 2
            && uf2.readUInt32LE(at + 28) === family)
        pages.push(uf2.subarray(at + 32, at + 288));
process.exit(Buffer.concat(pages).equals(image) ? 0 : 1);' "$1" "$2" "$3"
}
check "the UF2 file holds the image" uf2_holds "$image.uf2" "$image.bin" e48bff56
refuse "not another file" uf2_holds "$image.uf2" "$image.elf" e48bff56

host_crcs()     # FIRST LAST [OPTION]...
{
    frames=$1:$2
    shift 2
    "$program" render "${scene%@*}" --texels "${scene#*@}" --size 320x240 --hash \
        --format rgb565be --frames "$frames" "$@" | sed 's/^frame [0-9]* //'
}

# -- Pico 2 ----------------------------------------------------------------------------

image2=build/pico2/scenes/$scene
starts_here()   # IMAGE: what the boot ROM of an RP2350 needs
{
    node $here/image_def.js "$1"
}
altered()       # BYTE: the image with another byte there
{
    { head -c "$1" "$image2.bin"; printf '\377'; tail -c +$(($1 + 2)) "$image2.bin"; } \
        >"$scratch/altered.bin"
    starts_here "$scratch/altered.bin"
}
check "Pico 2: the UF2 file holds the image" uf2_holds "$image2.uf2" "$image2.bin" e48bff59
refuse "for no Pico" uf2_holds "$image2.uf2" "$image2.bin" e48bff56
check "Pico 2: block, stack and entry are right" starts_here "$image2.bin"
block=$(sed -n 's/^block at \([0-9]*\),.*/\1/p' "$scratch/output")
refuse "with another type of image" altered $((block + 6))
refuse "with another last word" altered $((block + 16))
refuse "with another entry" altered 7
refuse "the image of a Pico" starts_here "$image.bin"

# The cores run by turns of counted instructions, so the machine's load moves no tile.
two_cores_draw()        # FIRST: two emulated Cortex-M33 draw the host's frames, each a fifth
{
    timeout 60 qemu-system-arm -M mps2-an521 -global sse-200.CPU0_DSP=on -nographic \
        -icount shift=4,sleep=off -monitor none -serial null \
        -chardev file,id=said,path="$scratch/said" \
        -semihosting-config enable=on,target=native,chardev=said \
        -kernel build/pico2/two_cores/$scene.elf </dev/null || return 1
    is "$(sed -n 's/^frame [0-9]* //p' "$scratch/said")" "$(host_crcs "$1" $(($1 + 1)))" &&
        awk '$1 == "tiles" { least = ($2 + $3) / 5; good = $2 > least && $3 > least }
            END { exit !good }' "$scratch/said"
}
if ! lacks qemu-system-arm qemu-system-arm "two Cortex-M33"; then
    check "Pico 2: a program for two emulated cores builds" \
        alone build -s BOARD=pico/pico2 build/pico2/two_cores/$scene.elf
    check "Pico 2: two Cortex-M33 draw frames 60 and 61 of the host" two_cores_draw 60
    refuse "and not 61 and 62" two_cores_draw 61
fi

# -- registers -------------------------------------------------------------------------

same_registers()        # CHIP [OPTION]: as the headers of the Pico SDK define them
{
    cc -std=c11 -Wall -Wextra -Werror -Iports \
        -I"$PICO_SDK_PATH/src/$1/hardware_regs/include" ${2:-} \
        -fsyntax-only $here/registers.c
}
if [ -d "${PICO_SDK_PATH:-}/src/rp2350" ]; then
    check "registers of an RP2040" same_registers rp2040
    check "registers of an RP2350" same_registers rp2350 -DRP2350
    refuse "not one for the other" same_registers rp2350
fi

# -- frames ----------------------------------------------------------------------------

emulated()      # IMAGE [PICTURES]: frames from 60 on into $scratch/said
{
    arm-none-eabi-nm "${1%.*}.elf" | timeout 300 node $here/run.js $client "$@" \
        >"$scratch/said"
}
row()           # CORES: of the program in $image that drew last
{
    arm-none-eabi-size -A "$image.elf" >"$scratch/size" &&
        memory_of "$(dirname "$image")/../baked/$scene.c" >"$scratch/head" &&
        awk -v scene="$scene" -v cores="$1" -v format=rgb565be -v tiles=64x16 \
            -f tests/boards/pico.awk "$scratch/size" "$scratch/head" "$scratch/said"
}
# Rows of all measured scenes, by both cores and by one.
measure()       # CORES BUILD [VARIABLE=VALUE]...
{
    cores=$1 folder=$2
    shift 2
    for scene in $measured; do
        image=build/$folder/scenes/$scene
        build -s BOARD=pico TARGET="$folder" "$@" SCENE="$scene" elf uf2 \
            >"$scratch/log" 2>&1 && emulated "$image.bin" && row "$cores" >>"$scratch/rows" ||
            { cat "$scratch/log" "$scratch/said"; return 1; }
    done
}
crcs()          # FRAMES...: CRCs of the panel's pictures
{
    for frame in "$@"; do
        sed -n "s/^frame 00$frame //p" "$scratch/said"
    done
}
frames_are()    # FIRST: frames 60 and 61 equal the host's from FIRST on
{
    is "$(crcs 60 61)" "$(host_crcs "$1" "$(($1 + 1))")"
}
# Frame 62: the button's input is echoed as a line of a tape.
changed_is()    # [OPTION]...
{
    { echo "tape 2 ${scene%@*}"; grep '^61 ' "$scratch/said"; } >"$scratch/tape"
    is "$(crcs 62)" "$(host_crcs 62 62 --tape "$scratch/tape" "$@")"
}
state_is()      # the CRC of a second drawing, by core 0 alone
{
    grep -q "^ok tick 62 $(crcs 62), .* dropped 0," "$scratch/said"
}
both_draw()     # each core draws two fifths of the tiles' work at least
{
    awk '$1 == "instructions" && ($6 < 0.4 * ($6 + $7) || $7 < 0.4 * ($6 + $7)) { bad = 1 }
        $1 == "instructions" { n++ } END { exit bad || n != 3 }' "$scratch/said"
}
flash_rests()   # PERCENT: of the instructions, at most, are those of functions in flash
{
    awk -v percent="$1" '
        $1 == "instructions" || $1 == "flash" {
            for (i = 3; i <= NF; i++) if (i % 3 != 2) sum[$1] += $i
        }
        END {
            all = sum["instructions"]
            exit !(all && 100 * sum["flash"] < percent * all)
        }
    ' "$scratch/said"
}
stacks_hold()   # with room for an exception's frame
{
    awk '$1 == "stack" && ($3 == 0 || $3 > 4096 - 256) { bad = 1 }
        $1 == "stack" { n++ } END { exit bad || n != 2 }' "$scratch/said"
}
answers()       # each line is answered
{
    for answer in pause "step 60" "step 1" "light.elevation = 50"; do
        grep -q "^ok $answer" "$scratch/said" || return 1
    done
}
if [ -n "$write" ]; then
    check "rows by both cores" measure 2 pico
    check "rows by one core" measure 1 pico-one CORE_AT=build/pico-one/core \
        CPPFLAGS=-DPICO_CORES=1
    [ "$failed" != 0 ] || rows_put "$scratch/rows"
    finish
    exit
fi
check "the boot ROM starts it, and it draws" emulated "$image.bin"
check "frames 60 and 61 are the host's" frames_are 60
refuse "they are not 61 and 62" frames_are 61
check "a button and a line change frame 62 as on the host" \
    changed_is --set light.elevation=50
refuse "without the line it is another picture" changed_is
check "one core draws the same" state_is
check "both cores draw" both_draw
check "99 of 100 instructions run in RAM" flash_rests 1
refuse "but not 999 of 1000" flash_rests 0.1
check "the stacks stay in their banks" stacks_hold
check "the serial port answers" answers
check "the panel is turned, rows from its long side" \
    grep -q '^panel walk 28 plain' "$scratch/said"
check "a stack that overflows is told" \
    grep -q '^error the stack of core 1 overflowed' "$scratch/said"

# -- the rows of configurations.csv ----------------------------------------------------

in_table()      # FILE: has the row of this program
{
    row 2 >"$scratch/row" || { cat "$scratch/row"; return 1; }
    grep -qxF -f "$scratch/row" "$1" || { cat "$scratch/row"; return 1; }
}
if rows_comparable; then
    check "configurations.csv has the measured row" in_table $rows
    sed 's/[0-9]$/x/' $rows >"$scratch/other"
    refuse "a table with other figures has not" in_table "$scratch/other"
fi

# -- another panel ---------------------------------------------------------------------

other=build/pico/st7789/$scene
check "the program builds for an ST7789" alone build -s BOARD=pico $other.elf $other.bin
first_frame()   # PROGRAM FRAME: the emulated program's first picture is the host's FRAME
{
    emulated "$1.bin" 1 && is "$(crcs 60)" "$(host_crcs "$2" "$2")"
}
check "ST7789: frame 60 is the host's" first_frame $other 60
check "its rows are turned the other way, its colours inverted" \
    grep -q '^panel walk [1-9a-f][0-9a-f]* inverted' "$scratch/said"

# -- arithmetic ------------------------------------------------------------------------

calculates()
{
    arm-none-eabi-objcopy -O binary -j .data "$image.elf" "$scratch/code" &&
        arm-none-eabi-nm "$image.elf" |
        node $here/arithmetic.js $client "$scratch/code" 20000000
}
check "products and quotients are right" calculates

# -- a wrong image ---------------------------------------------------------------------

spoilt()        # a byte of stage 2 differs from what its CRC says
{
    { head -c 20 "$image.bin"; printf '\377'; tail -c +22 "$image.bin"; } >"$scratch/bad.bin"
    cp "$image.elf" "$scratch/bad.elf"
    ! emulated "$scratch/bad.bin" && grep -q "refuses stage 2" "$scratch/said"
}
check "the boot ROM refuses a spoilt stage 2" spoilt
finish
