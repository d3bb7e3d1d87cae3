#!/bin/sh
# SPDX-License-Identifier: MIT
# Bare Cortex-M boards, emulated: their frames are the host's, their memory is enough, what
# goes wrong on them is told, and their rows of configurations.csv are what is measured.
#     cortex-m.sh PROGRAM
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/board.sh"
. "$(dirname "$0")/../lib/rows.sh"

program=$1
shots=$scratch/shots
lacks arm-none-eabi-gcc gcc-arm-none-eabi "Cortex-M boards" && exit 0
lacks qemu-system-arm qemu-system-arm "Cortex-M boards" && exit 0

# -- frames ---------------------------------------------------------------------------

said()          # WORD FILE: the text behind the word
{
    awk -v word="$1" '{ for (i = 1; i < NF; i++) if ($i == word) print $(i + 1) }' "$2"
}
hashes()        # SCENE[@TEXELS] SIZE FORMAT FIRST: two frames, by the host
{
    ini=${1%@*}
    for folder in ports/cortex-m/scenes tests/budgets; do
        [ ! -f "$folder/$ini.ini" ] || ini=$folder/$ini.ini
    done
    texels=
    case $1 in *@*) texels="--texels ${1#*@}" ;; esac
    # shellcheck disable=SC2086
    "$program" render "$ini" $texels --size "$2" --format "$3" --hash \
        --frames "$4:$(($4 + 1))" | sed 's/^frame [0-9]* //'
}
frames_are()    # BOARD/SCENE FIRST: two frames equal the host's
{
    of=$shots/$1.said
    hashes "${1#*/}" $(awk '/^picture/ { print $2, $3 }' "$of") "$2" >"$scratch/want"
    sed -n 's/^frame [0-9]* //p' "$of" >"$scratch/got"
    [ "$(wc -l <"$scratch/got")" = 2 ] && diff "$scratch/want" "$scratch/got"
}
whole()         # BOARD/SCENE: nothing was left out
{
    [ "$(said dropped "$shots/$1.said" | sort -u)" = 0 ]
}
links_its_list()        # BOARD/SCENE: and no other module
{
    pieces_of "build/${1%/*}/scenes/${1#*/}.elf" >"$scratch/pieces"
    links_no_more "$scratch/pieces" "build/${1%/*}/baked/${1#*/}.c"
}
links_another() # BOARD/SCENE: the same with a module in no list of these boards
{
    pieces_of "build/${1%/*}/scenes/${1#*/}.elf" >"$scratch/pieces"
    echo tp_stage_foam >>"$scratch/pieces"
    links_no_more "$scratch/pieces" "build/${1%/*}/baked/${1#*/}.c"
}
walks_with_a_glint()    # BOARD/SCENE: its list has no other water renderer
{
    list=build/${1%/*}/baked/${1#*/}.c
    grep -qx ' \*     method walk' "$list" && grep -qx ' \*     stage  glint' "$list"
}
stack_holds()   # BOARD/SCENE: with room for an exception's frame
{
    of=$shots/$1.said
    [ "$(($(said stack "$of") + 32))" -le "$(said reserve "$of")" ]
}

mkdir "$shots"
check "programs of all boards build, and run to their end" \
    sh -c "tests/boards/table.sh '$shots' >'$scratch/table'"
[ "$failed" = 0 ] || exit 1
for shot in "$shots"/*/*.said; do
    shot=${shot#"$shots/"} shot=${shot%.said}
    check "$shot: frames 60 and 61 are the host's" frames_are "$shot" 60
    refuse "$shot: they are not 61 and 62" frames_are "$shot" 61
    check "$shot: nothing was left out" whole "$shot"
    check "$shot: the stack stays in its reserve" stack_holds "$shot"
    check "$shot: no piece is linked that its list lacks" links_its_list "$shot"
    refuse "$shot: nor is foam" links_another "$shot"
done
for board in stm32vldiscovery microbit; do
    check "$board: bay is walked, with a glint" walks_with_a_glint "$board/bay@64"
done
refuse "lm3s6965evb: tarn is not" walks_with_a_glint lm3s6965evb/tarn

# -- faults ---------------------------------------------------------------------------

# emulate BOARD ELF: sets the exit code in $code; output in $scratch/said
emulate()
{
    timeout 20 qemu-system-arm -M "$1" -nographic -monitor none -serial null \
        -chardev file,id=said,path="$scratch/said" -kernel "$2" \
        -semihosting-config enable=on,target=native,chardev=said </dev/null
    code=$?
    cat "$scratch/said"
}
faults()        # BOARD FOLDER WHAT LINE: ends with 139 and prints only this line
{
    emulate "$1" "$2/faults/$3.elf"
    [ $code = 139 ] && [ "$(wc -l <"$scratch/said")" = 2 ] &&
        grep -q "^fault $4" "$scratch/said"
}
in_main()       # FOLDER WHAT: the reported address lies in the faulty function
{
    arm-none-eabi-nm -S "$1/faults/$2.elf" | awk -v at="$(sed -n \
        's/^fault .* at \([0-9a-f]*\),.*/\1/p' "$scratch/said")" '
        $4 == "main" && at >= $1 { seen = at < sprintf("%08x", 1 + number($1) + number($2)) }
        function number(hex,    i, n) {
            for (i = 1; i <= length(hex); i++)
                n = 16 * n + index("0123456789abcdef", substr(hex, i, 1)) - 1
            return n
        }
        END { exit !seen }'
}
too_large()     # BOARD
{
    ! alone build -s BOARD="cortex-m/$1" "build/$1/faults/ram.elf" >"$scratch/log" 2>&1 &&
        grep "region .RAM' overflowed" "$scratch/log"
}
faulty()        # BOARD FOLDER WHAT...: builds the faulty programs
{
    kind=$1 folder=$2 goals=
    shift 2
    for what; do
        goals="$goals $folder/faults/$what.elf"
    done
    # shellcheck disable=SC2086
    alone build -s BOARD="$kind" $goals
}

for board in netduinoplus2 stm32vldiscovery microbit; do
    check "$board: programs that go wrong build" \
        faulty cortex-m/$board build/$board address instruction stack
    check "$board: an address of nothing is told, exit 139" \
        faults $board build/$board address "3 at "
    check "$board: with its place" in_main build/$board address
    check "$board: so is no instruction" faults $board build/$board instruction "3 at "
    check "$board: and a stack that overflows" \
        faults $board build/$board stack "3: the stack overflowed"
    check "$board: more RAM than it has is refused by the linker" too_large $board
done
check "mps2-an386: a program that goes wrong builds" faulty cortex-m build/cortex-m \
    instruction
check "mps2-an386: no instruction is told, exit 139" \
    faults mps2-an386 build/cortex-m instruction "3 at "
check "mps2-an386: count-64 builds" alone build -s BOARD=cortex-m SCENE=count-64 elf
draws()         # FIRST
{
    emulate mps2-an386 build/cortex-m/scenes/count-64.elf
    mkdir -p "$shots/mps2-an386"
    cp "$scratch/said" "$shots/mps2-an386/count-64.said"
    [ $code = 0 ] && frames_are mps2-an386/count-64 "$1"
}
check "mps2-an386: its frames are the host's" draws 60
refuse "mps2-an386: and no others" draws 61

# -- the rows -------------------------------------------------------------------------

stands_in()     # FILE: has the measured rows
{
    [ -s "$scratch/table" ] && ! grep -vxF -f "$1" "$scratch/table"
}
if rows_comparable; then
    check "configurations.csv has what make boards prints" stands_in $rows
    sed 's/[1-9]$/0/' $rows >"$scratch/stale"
    refuse "rows with another figure have not" stands_in "$scratch/stale"
fi
finish
