# SPDX-License-Identifier: MIT
# shellcheck shell=sh disable=SC2034
# Functions for test scripts, read from the project's root by
#     . "$(dirname "$0")/../lib/script.sh"
# Each case prints a line, "ok - NAME" or "FAILED - NAME". `finish` prints "N passed, M
# failed" and returns the exit code. $scratch is a folder that is removed at the end.

passed=0 failed=0
scratch=$(mktemp -d) || exit 2
messages=$scratch/messages      # file that explains a failure; its end is shown

# at_end COMMAND: runs a command at the end of the script, the latest one first.
last_steps=
at_end() { last_steps="$1; $last_steps"; }
trap 'eval "$last_steps"; rm -rf "$scratch"' EXIT
trap 'exit 1' INT TERM HUP

pass()          # NAME
{
    passed=$((passed + 1))
    echo "ok - $1"
}
fail()          # NAME [REASON]
{
    failed=$((failed + 1))
    echo "FAILED - $1${2:+: $2}"
    [ ! -s "$messages" ] || tail -n 5 "$messages" | sed 's/^/     | /'
}

# verdict NAME REASON: passed if the reason is empty.
verdict()       { if [ -z "$2" ]; then pass "$1"; else fail "$1" "$2"; fi; }

# same NAME TEXT TEXT: expects equal texts.
same()          { if [ "$2" = "$3" ]; then pass "$1"; else fail "$1" "'$2' is not '$3'"; fi; }

# is TEXT TEXT: true if the texts are equal; otherwise prints both.
is()            { [ "$1" = "$2" ] || { echo "'$1' is not '$2'"; return 1; }; }

# check NAME COMMAND...: one case; prints the command's output if the case fails.
check()
{
    case_name=$1; shift
    if "$@" >"$scratch/output" 2>&1; then
        pass "$case_name"
    else
        sed 's/^/    /' "$scratch/output"
        fail "$case_name"
    fi
}

# refuse NAME COMMAND...: a case that passes if the command finds an error.
refuse()
{
    case_name=$1; shift
    if "$@" >"$scratch/output" 2>&1; then
        fail "$case_name" "nothing was found"
    else
        pass "$case_name"
    fi
}

skip()          { echo "skipped: $1 (package $2)"; }    # NAME PACKAGE

# lacks TOOL PACKAGE NAME: true, with a message, if the tool is missing.
lacks()         { ! command -v "$1" >/dev/null && skip "$3" "$2"; }

finish()
{
    echo "$passed passed, $failed failed"
    [ "$failed" -eq 0 ]
}

# until_true COMMAND...: repeats a command until it succeeds, for at least ten seconds.
until_true()
{
    for _ in $(seq 500); do
        "$@" && return 0
        sleep 0.02
    done
    return 1
}

# A separate build, independent of a make that may have called this script.
build()         # [VARIABLE=VALUE]... GOAL...
{
    env -u MAKEFLAGS -u MAKELEVEL -u MFLAGS make -j2 --no-print-directory "$@"
}

# alone COMMAND...: runs commands that build for other processors one at a time, since
# several tests use their output.
alone()
{
    mkdir -p build/cross && (flock 9 && "$@") 9<build/cross
}

# for_aarch64 GOAL...: builds for aarch64 in $aarch64, the build of which
# tests/cross/run.sh draws its frames.
aarch64=cross/aarch64-clang-O3
for_aarch64()
{
    triple=aarch64-linux-gnu
    alone build TARGET=$aarch64 MACHINE=aarch64 OPT=-O3 CHECKED= LDFLAGS=-static \
        CC="clang --target=$triple -isystem /usr/$triple/include" AR=$triple-ar "$@"
}

# -- runs of the program -----------------------------------------------------------------

limit=60                        # seconds of a run

# program_begin PROGRAM: cases of the program in a folder of their own, $work; its last
# messages are in file err. The project's root is $root.
program_begin()
{
    program=$(realpath "$1") && vectors=$(realpath tests/vectors) || exit 2
    root=$PWD work=$scratch/work messages=err
    mkdir "$work" && cd "$work" || exit 2
}

# run ARGUMENT...: runs the program, with streams to files out and err, exit code in
# $code.
run()
{
    timeout "$limit" "$program" "$@" >out 2>err </dev/null
    code=$?
}

# expect NAME CODE PATTERN ARGUMENT...: expects an exit code, and a line of stderr
# matching a basic regular expression; "" expects an empty stderr.
expect()
{
    name=$1 want=$2 pattern=$3
    shift 3
    run "$@"
    judge "$name" "$want" "$pattern"
}

judge()         # NAME CODE PATTERN
{
    if [ "$code" -ne "$2" ]; then
        fail "$1" "exit code $code, expected $2"
    elif [ -z "$3" ] && [ -s err ]; then
        fail "$1" "unexpected message"
    elif [ -n "$3" ] && ! grep -q -e "$3" err; then
        fail "$1" "no message like '$3'"
    else
        pass "$1"
    fi
}

# fits ARGUMENT...: expects an output that fits a screen.
fits()
{
    run "$@"
    wide=$(awk 'length($0) > 80' out | wc -l)
    same "$* fits 24 lines of 80 columns" \
        "$code $([ "$(wc -l <out)" -le 24 ] && [ -s out ] && echo low) $wide" "0 low 0"
}

# on_terminal NAME: true if script(1) can give a program a terminal. Otherwise NAME is
# skipped, with the reason.
on_terminal()
{
    lacks script bsdutils "$1" && return 1
    script -qec true /dev/null >/dev/null 2>&1 </dev/null && return 0
    echo "skipped: $1 (no pseudo-terminal can be had: is /dev/pts mounted?)"
    return 1
}

# -- rules on sources and archives -------------------------------------------------------

gates=tests/gates
strict="-pedantic-errors -Wall -Wextra -Wconversion -Wshadow -Werror"

# Gates on an archive, with the tools of a target: "" is this machine, or
# "arm-none-eabi-".
symbols()     { "$1nm" -A "$2" | awk -f $gates/symbols.awk; }
no_state()    { "$1size" -A "$2" | awk -f $gates/state.awk; }
no_deeper()                     # BYTES FILE.ci...
{
    bytes=$1; shift
    awk -v limit="$bytes" -v pointers=$gates/pointers.txt -f tests/lib/callgraph.awk \
        -f $gates/stack.awk "$@"
}
no_floats()   { objdump -d --no-show-raw-insn "$1" | awk -f $gates/floats.awk; }

# headers_alone CC CXX [FOLDER]: each header of FOLDER/tidepool compiles alone, included
# twice, by each standard of C and C++ that it supports.
headers_alone()
{
    folder=${3:-include} alone=$scratch/alone
    rm -rf "$alone" && mkdir "$alone" || return 1
    for header in "$folder"/tidepool/*.h; do
        file=$alone/$(basename "$header" .h)
        printf '#include "tidepool/%s"\n' "${header##*/}" "${header##*/}" >"$file.c"
        echo 'extern int some_declaration;' >>"$file.c"
        cp "$file.c" "$file.cpp"
    done
    for standard in c11 c17; do
        echo "$1, $standard:"
        "$1" -std=$standard $strict -fsyntax-only -I"$folder" "$alone"/*.c || return 1
    done
    for standard in c++11 c++14 c++17 c++20; do
        echo "$2, $standard:"
        "$2" -std=$standard $strict -fsyntax-only -I"$folder" "$alone"/*.cpp || return 1
    done
}

# The README's first program, unchanged, with a show() that prints the CRC-32 of picture
# 30 and ends; fails unless all pixels of each picture were shown.
first_program()
{
    cat <<'END'
#include <stdio.h>
#include <stdlib.h>
#include "tidepool/tidepool.h"
static void show(const tp_tile *tile);
END
    sed -n '/^## A first program/,/^## /s/^    //p' README.md
    cat <<'END'
static void show(const tp_tile *tile)
{
    static uint32_t shown, pictures, crc;
    for (uint32_t y = tile->y0; y < tile->y1; y++, shown += tile->x1 - tile->x0)
        crc = tp_crc32_pixels(crc, TP_FORMAT_XRGB8888,
                              (const char *)tile->pixels + (y - tile->y0) * tile->stride,
                              (int)(tile->x1 - tile->x0));
    if (tile->y1 < 240)
        return;
    if (pictures++ == 30)
        exit(printf("%08x\n", (unsigned)crc) < 0);
    if (shown != 320 * 240)
        exit(1);
    shown = crc = 0;
}
END
}
