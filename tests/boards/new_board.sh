#!/bin/sh
# SPDX-License-Identifier: MIT
# Projects that `make new-board` starts: built by their Makefile and by CMake, they draw the
# host's picture under the emulator, and say it if RAM or panel fail.  Wrong values are
# refused, and nothing is written then.
#     new_board.sh PROGRAM
. "$(dirname "$0")/../lib/script.sh"

program=${1:-build/host/tidepool}
lacks arm-none-eabi-gcc gcc-arm-none-eabi "projects for new boards" && exit 77
lacks qemu-system-arm qemu-system-arm "projects for new boards" && exit 77
parent=$scratch/parent
mkdir "$parent"

begin()         { ports/new_board.sh "$@" 2>&1; }
known="cortex-m0 cortex-m0plus cortex-m3 cortex-m4 cortex-m7 cortex-m33"

# -- refusals -----------------------------------------------------------------------------

# refuses WHAT PATTERN NAME=VALUE...: exit code 2, a message, and an empty parent folder.
refuses()
{
    what=$1 pattern=$2
    shift 2
    text=$(begin "$@")
    code=$?
    found=$(echo "$text" | grep -c -e "$pattern")
    same "refused: $what" "$code $found $(ls -A "$parent")" "2 1 "
}
new=DIR=$parent/new
usage() { [ $# = 0 ] && build -s new-board | grep -q '^  CPU  *cortex-m0 '; }
check "without values make new-board prints its usage" usage
refuses "an unknown CPU, with the known ones" "known: $known$" CPU=cortex-m9 "$new"
refuses "no CPU" "CPU is missing; known: $known$" "$new"
refuses "no folder" "DIR is missing" CPU=cortex-m4
refuses "a folder in no folder" "no folder $parent/no" CPU=cortex-m4 "DIR=$parent/no/new"
refuses "an unknown value" "unknown: 'COLOUR=red'" CPU=cortex-m4 "$new" COLOUR=red
refuses "an unknown panel" "known: ili9341" CPU=cortex-m4 "$new" PANEL=oled
refuses "a picture larger than the panel" "larger than" CPU=cortex-m4 "$new" SIZE=321x240
refuses "a size that is none" "SIZE is WxH" CPU=cortex-m4 "$new" SIZE=320
refuses "a flash that is none" "no size of FLASH" CPU=cortex-m4 "$new" FLASH=big
refuses "an unknown scene" "nothing is written" CPU=cortex-m4 "$new" SCENE=no-such
by_make()       { ! build -s new-board CPU=cortex-m9 "$new" && [ ! -e "$parent/new" ]; }
check "make fails then too" by_make
echo kept >"$parent/file"
keeps()         # DIR MESSAGE: refused with it; the file is still there, alone
{
    begin CPU=cortex-m4 "DIR=$1" | grep "$2\$" &&
        is "$(ls -A "$parent") $(cat "$parent/file")" "file kept"
}
check "refused: a file" keeps "$parent/file" "is a file"
check "refused: a folder with a file" keeps "$parent" "is not empty"

# -- a project and its files --------------------------------------------------------------

# The folder's name has a blank.
first=$parent/a\ board second=$parent/second
mkdir "$first"                  # an empty folder is taken
check "a project for a Cortex-M0+ begins, in an empty folder" build -s new-board \
    CPU=cortex-m0plus DIR="$first" SCENE=minimal SIZE=128x64 PICTURE="--texels 16"
check "a project for a Cortex-M4 with another panel begins" begin CPU=cortex-m4 RAM=64K \
    "DIR=$second" SCENE=minimal SIZE=128x64 "PICTURE=--texels 16" PANEL=st7789_135x240
[ "$failed" = 0 ] || { finish; exit; }

open_ends()     # FOLDER: files without a licence line, and values not filled in
{
    for file in "$1"/*; do
        case $file in */README.md) ;; *)
            head -n 3 "$file" | grep -q 'SPDX-License-Identifier: MIT' || echo "$file" ;;
        esac
        awk '/@[A-Z_]+@/ { print FILENAME ":" FNR ": " $0 }' "$file"
    done
}
verdict "its files have licence lines, and all values" "$(open_ends "$first")"
bakes()
{
    cp "$first/scene.c" "$scratch/scene.c" && rm "$first/scene.c" &&
        build -s -C "$first" bake && cmp "$first/scene.c" "$scratch/scene.c"
}
check "its scene can be baked again" bakes
printed()       # FOLDER: the command of its README prints what scene.sh prints
{
    command=$(sed -n '/^    tidepool render/,/--hash/p' "$1/README.md" | tr -d '\\\n')
    # shellcheck disable=SC2086
    set -- "$1" ${command#*tidepool}
    folder=$1; shift
    is "$("$program" "$@")" "$("$folder/scene.sh" crc)"
}
check "its README has the command that prints the CRC" printed "$first"
check "so has the other" printed "$second"

compiles()      # CPU: its own files, by the flags and the templates of the processor
{
    begin "CPU=$1" "DIR=$parent/$1" SCENE=minimal "PICTURE=--texels 16" &&
        build -s -C "$parent/$1" OPT=-O0 build/main.o build/start.o build/board.o
}
for cpu in cortex-m0 cortex-m3 cortex-m7 cortex-m33; do
    check "a project for a $cpu compiles" compiles $cpu
done

# small: the core's files that a list of compilers' commands compiles for size.
small()
{
    grep -e ' -Os ' | grep -o ' -c [^ ]*src/[a-z0-9_/]*\.c' | sed 's,.*src/,,' | sort -u
}
build -s -B -n V=1 BOARD=cortex-m/m0plus lib | small >"$scratch/small"
check "boards compile files of little work for size" test -s "$scratch/small"
same_small()    { small >"$scratch/other" && diff "$scratch/small" "$scratch/other"; }
by_makefile()   { build -s -B -n -C "$second" build/libtidepool.a | same_small; }
check "Makefile: the same files" by_makefile
by_cmake()
{
    env -u MAKEFLAGS cmake -S "$second" -B "$scratch/cmake" \
        -DCMAKE_EXPORT_COMPILE_COMMANDS=ON >"$scratch/said" &&
        grep '"command":' "$scratch/cmake/compile_commands.json" | same_small
}
lacks cmake cmake "a new board's project by CMake" || check "CMake: the same files" by_cmake

# -- runs ---------------------------------------------------------------------------------

# A checkout with those files of the library alone that the program links with the built
# library of the same processor: other files need not be compiled.
checkout=$scratch/checkout
small_checkout()
{
    alone build -s BOARD=cortex-m/m0plus lib &&
        build -s -C "$first" LIB="$PWD/build/cortex-m0plus/libtidepool.a" OPT=-O1 &&
        mkdir "$checkout" && cp -r src CMakeLists.txt "$checkout" &&
        ln -s "$PWD/include" "$PWD/ports" "$checkout" || return 1
    grep -o 'libtidepool\.a([a-z0-9_]*\.o)' "$first/build/board.map" | sort -u |
        sed 's,.*(\(.*\)\.o),/\1.c,' >"$scratch/linked"
    find "$checkout/src" -name '*.c' | grep -v -F -f "$scratch/linked" | xargs rm
    mkdir -p "$checkout/build/host" && ln -s "$(realpath "$program")" "$checkout/build/host"
}
check "Makefile: the program links a library that is built" small_checkout

want=$("$program" render minimal --texels 16 --size 128x64 --format rgb565be \
    --frames 60:60 --hash)
made()          { build -s -C "$first" TIDEPOOL="$checkout" OPT=-O1 "$@"; }
said()          { grep -x "frame 0060 crc32 [0-9a-f]*" "$1"; }
anew()          { made clean && made check; }
check "Makefile: both are built, and the picture is checked" anew
check "Makefile: it is the host's" is "$(said "$first/build/said")" "$want"
sed -i 's/^size=.*/size=128x60/' "$first/scene.sh"
refuse "Makefile: another picture is not" made check

# changed FILE SED CODE LINE: the program ends with a code and says a line.
changed()
{
    cp "$first/$1" "$scratch/kept" && sed -i "$2" "$first/$1"
    made run >"$scratch/said" 2>&1
    cp "$scratch/kept" "$first/$1"
    cat "$scratch/said"
    grep -q "^$4" "$scratch/said" && grep -q "Error $3\$" "$scratch/said"
}
check "it says that RAM is missing" changed board.ld 's/= 256K/= 16K/' 3 "not enough RAM: "
check "it says that the panel blocks" changed board.c 's/return true;/return false;/' 4 \
    "the panel does not answer"
check "it says a fault" changed main.c 's/^    make_world();/    __asm__ ("udf 0");/' 139 \
    "fault: "

# The folder is moved: the checkout is named.
cmade()
{
    mkdir "$parent/further" && mv "$second" "$parent/further" || return 1
    second=$parent/further/second
    env -u MAKEFLAGS cmake -S "$second" -B "$second/out" -DTIDEPOOL="$checkout" \
        -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_FLAGS_RELEASE=-O1 &&
        env -u MAKEFLAGS -u MAKELEVEL cmake --build "$second/out" -j2 &&
        env -u MAKEFLAGS -u MAKELEVEL cmake --build "$second/out" --target run \
            </dev/null >"$scratch/said" 2>&1
}
lacks cmake cmake "a new board's project by CMake" && { finish; exit; }
check "CMake: the program of the moved project is built, and runs" cmade
check "CMake: it draws the host's picture" is "$(said "$scratch/said")" "$want"
finish
