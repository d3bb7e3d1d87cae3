#!/bin/sh
# SPDX-License-Identifier: MIT
# Equal bits everywhere: builds the core and tests/cross/frames for each machine, compiler
# and optimisation level, and compares the golden frames' CRCs. Quick: a big-endian machine,
# by clang at -O2, and a bare Cortex-M33, emulated. With TP_SOAK set each machine gets all
# pairs, -O0 and LTO too, and a bare Cortex-M4 and Cortex-M0+ draw. Other tests draw golden
# frames on this machine, by gcc at -O2, with pixel loops at -O3, and sanitized at -O1; on
# 32-bit wasm; and films on aarch64. Asserts are on except at -O3 and on boards, whose frames
# are those of a release.
#
# -O2 draws all pixel formats, the other levels only xrgb8888. LTO is gcc with -O2 -flto,
# which compiles the whole core again for each scene: LTO draws two scenes.
. "$(dirname "$0")/../lib/script.sh"

scenes=$(build -s list-cross)
scenes_of_lto='three-swells rolled'

# name | GNU triple | emulator | Debian's name of the machine | levels of gcc, of clang
all='O0 O1 Os O2 O3 LTO'
machines="
host    |                     |              |         | -     | -
i386    | i686-linux-gnu      | qemu-i386    | i386    | -     | -
armhf   | arm-linux-gnueabihf | qemu-arm     | armhf   | -     | -
aarch64 | aarch64-linux-gnu   | qemu-aarch64 | arm64   | -     | -
riscv64 | riscv64-linux-gnu   | qemu-riscv64 | riscv64 | -     | -
s390x   | s390x-linux-gnu     | qemu-s390x   | s390x   | -     | O2
"

# "three-swells rgb565 frame 0000 crc32 1234abcd": expected lines; the drawn lines look
# the same.
for scene in $scenes; do
    for list in "tests/golden/$scene"/*.crc; do
        sed "s/^/$scene $(basename "$list" .crc) /" "$list"
    done
done | sort >"$scratch/expected"
frames_at()     # LEVEL: the golden frames drawn at that level
{
    case $1 in
    O2)  cat "$scratch/expected" ;;
    *)   for scene in $(scenes_at "$1"); do
             grep "^$scene xrgb8888" "$scratch/expected"
         done | sort ;;
    esac
}
scenes_at()     # LEVEL
{
    case $1 in
    LTO) echo $scenes_of_lto ;;
    *)   echo $scenes ;;
    esac
}
draw()          # FOLDER FRAMES: draws them with FOLDER's programs, one scene a core
{
    rm -rf "$scratch/drawn" && mkdir "$scratch/drawn" || return 1
    cut -d' ' -f1,2 "$2" | uniq |
        emulator=$emulator folder=$1 to=$scratch/drawn xargs -P "$(nproc)" -n 2 sh -c '
            $emulator "$folder/frames-$1" "$2" >"$to/$1 $2" &&
                sed -i "s/^/$1 /" "$to/$1 $2"' draw || return 1
    cat "$scratch/drawn"/*
}
check "there are golden frames to compare with" test -s "$scratch/expected"

# try MACHINE COMPILER LEVEL: builds, runs, compares; prints "equal" or the error.
try()
{
    target=cross/$1-$2-$3
    baked=$1 ar=${triple:+$triple-}ar opt=-$3 goals= begun=$(date +%s)
    case $2 in
    gcc)   cc=${triple:+$triple-}gcc ;;
    clang) cc="clang${triple:+ --target=$triple -isystem /usr/$triple/include}" ;;
    esac
    if [ "$3" = LTO ]; then             # LTO objects have a format of their own
        baked=$1-lto ar=${triple:+$triple-}gcc-ar opt='-O2 -flto'
    fi
    for scene in $(scenes_at "$3"); do
        goals="$goals build/$target/tests/cross/frames-$scene"
    done
    if ! alone build TARGET="$target" MACHINE="$baked" CC="$cc" AR="$ar" OPT="$opt" \
        CHECKED="${3#O3}" LDFLAGS="${triple:+-static}" $goals >"$scratch/log" 2>&1; then
        tail -n 5 "$scratch/log"
        verdict=unbuilt
    elif frames_at "$3" >"$scratch/asked" &&
        ! draw "build/$target/tests/cross" "$scratch/asked" >"$scratch/frames"; then
        verdict=crashed
    elif ! sort "$scratch/frames" | diff "$scratch/asked" - >"$scratch/log"; then
        cat "$scratch/log"
        verdict=DIFFERENT
    else
        verdict=equal
    fi
    if [ $verdict = equal ]; then
        pass "$1 $2 -$3"
    else
        fail "$1 $2 -$3" "$verdict"
    fi
    echo "    $(($(date +%s) - begun)) s"
}

table=$(printf '%-8s %-6s' machine cc; printf ' %-9s' $all)
while IFS='|' read -r machine triple emulator debian by_gcc by_clang; do
    machine=${machine%% *}
    triple=$(echo $triple) emulator=$(echo $emulator) debian=$(echo $debian)
    [ -n "$machine" ] || continue
    case "${TP_SOAK:-}$by_gcc$by_clang" in
    *[!\ -]*) ;;
    *) continue ;;                      # in the soak only
    esac
    if [ -n "$triple" ]; then
        lacks "$triple-gcc" "gcc-$triple" "frames on $machine" && continue
        [ "$machine/$(uname -m)" != i386/x86_64 ] || emulator=      # runs them itself
        if [ -n "$emulator" ]; then
            lacks "$emulator" qemu-user "frames on $machine" && continue
        fi
        if [ ! -d "/usr/$triple/include" ]; then
            skip "frames on $machine" "libc6-dev-$debian-cross"
            continue
        fi
    fi
    for compiler in gcc clang; do
        lacks $compiler $compiler "frames on $machine by $compiler" && continue
        row=$(printf '%-8s %-6s' "$machine" $compiler)
        case $compiler in
        gcc)   levels=${TP_SOAK:+$all} levels=${levels:-$by_gcc} ;;
        clang) levels=${TP_SOAK:+${all% LTO}} levels=${levels:-$by_clang} ;;
        esac
        for level in $all; do
            verdict=-
            case $levels in
            *$level*) try "$machine" $compiler $level ;;
            esac
            row="$row$(printf ' %-9s' $verdict)"
        done
        table="$table
$row"
    done
done <<EOF
$machines
EOF
echo "$table"

# -- boards ----------------------------------------------------------------------------

board_draws()   # BOARD EMULATOR SCENE [OTHER]: its golden frames in xrgb8888, or OTHER's
{
    programs=build/${1##*/}/tests/cross
    timeout 100 qemu-system-arm -M "$2" -nographic -monitor none -serial null \
        -chardev file,id=said,path="$scratch/said" -kernel "$programs/frames-$3.elf" \
        -semihosting-config enable=on,target=native,chardev=said </dev/null || return 1
    sed -n "s/^${4:-$3} \(xrgb8888 \)/\1/p" "$scratch/expected" | diff - "$scratch/said"
}
draw_all()      # BOARD EMULATOR
{
    for scene in $scenes; do
        board_draws "$1" "$2" "$scene" || { echo "$scene"; return 1; }
    done
}
build_all()     # BOARD
{
    # shellcheck disable=SC2046
    alone build -s BOARD="$1" \
        $(for scene in $scenes; do echo "build/${1##*/}/tests/cross/frames-$scene.elf"; done)
}

boards='cortex-m/mps2-an505:mps2-an505'
[ -z "${TP_SOAK:-}" ] || boards="$boards cortex-m:mps2-an386 cortex-m/m0plus:mps2-an386"
for board in $boards; do
    emulator=${board#*:} board=${board%:*}
    lacks arm-none-eabi-gcc gcc-arm-none-eabi "frames on $board" && continue
    lacks qemu-system-arm qemu-system-arm "frames on $board" && continue
    check "programs for $board build" build_all "$board"
    check "$board draws the golden frames of all scenes" draw_all "$board" "$emulator"
    refuse "and no others" board_draws "$board" "$emulator" tank storm
done
finish
