# SPDX-License-Identifier: MIT
# Functions shared by the gates; read by `.`, from the project's root.

failures=0

# check NAME COMMAND...: one case; prints the command's output if the case fails.
check()
{
    name=$1; shift
    if "$@" >"$scratch/output" 2>&1; then
        echo "ok - $name"
    else
        sed 's/^/    /' "$scratch/output"
        echo "FAILED - $name"
        failures=$((failures + 1))
    fi
}

# refuse NAME COMMAND...: a case that passes if the command finds an error.
refuse()
{
    name=$1; shift
    if "$@" >"$scratch/output" 2>&1; then
        echo "FAILED - $name: nothing was found"
        failures=$((failures + 1))
    else
        echo "ok - $name"
    fi
}

# lacks TOOL PACKAGE NAME: true, with a message, if the tool is missing.
lacks()
{
    ! command -v "$1" >/dev/null && echo "skipped: $3 (package $2)"
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

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
gates=tests/gates

core_files()  { find include src -name '*.[ch]' -o -name '*.inc' | sort; }
port_files()  { find ports -name '*.[ch]' | sort; }
every_file()
{
    find . \( -name .git -o -path ./build -o -path ./out \) -prune -o -type f \
        \( -name '*.[ch]' -o -name '*.inc' -o -name '*.sh' -o -name '*.awk' \
           -o -name '*.cpp' -o -name '*.S' -o -name '*.mk' -o -name '*.ld' -o -name Makefile \
           -o -path './.ci/run' \) \
        -print | sort
}

# Gates on an archive, with the tools of a target: "" is this machine, or
# "arm-none-eabi-".
symbols()     { "$1nm" -A "$2" | awk -f $gates/symbols.awk; }
no_state()    { "$1size" -A "$2" | awk -f $gates/state.awk; }
no_deeper()                     # BYTES FILE.ci...
{
    bytes=$1; shift
    awk -v limit="$bytes" -v pointers=$gates/pointers.txt -f $gates/stack.awk "$@"
}
no_floats()   { objdump -d --no-show-raw-insn "$1" | awk -f $gates/floats.awk; }

strict="-pedantic-errors -Wall -Wextra -Wconversion -Wshadow -Werror"

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
