#!/bin/sh
# SPDX-License-Identifier: MIT
# The public headers are C and C++: each compiles alone without a warning, the declared
# functions link from both, and both draw the same picture. tests/gates/clang.sh compiles
# the headers with clang too.
. "$(dirname "$0")/../lib/script.sh"

library=${TP_BUILD:-build/host}/libtidepool.a

check "gcc compiles every public header alone, as C11 to C++20" headers_alone gcc g++

# Names of all functions and constants that the headers declare, except inline functions.
declared()
{
    echo '#include "tidepool/tidepool.h"' >"$scratch/all.c"
    gcc -std=c11 -Iinclude -fsyntax-only -aux-info "$scratch/functions" "$scratch/all.c" &&
        sed -n 's|.*tidepool/.* extern [^(]*[ *]\(tp_[a-z0-9_]*\) (.*|\1|p' \
            "$scratch/functions" | sort -u >"$scratch/names" &&
        gcc -std=c11 -Iinclude -E -P "$scratch/all.c" | tr ';' '\n' |
        sed -n 's/^ *extern const .* \(tp_[a-z0-9_]*\)$/\1/p' | sort -u >"$scratch/constants"
    wc -l "$scratch/names" "$scratch/constants"
    [ "$(wc -l <"$scratch/names")" -gt 120 ] && [ "$(wc -l <"$scratch/constants")" -gt 40 ]
}
check "the headers' functions and constants are found" declared

# An application needs few headers and few functions. Stages, stores, conditions and
# tp_lacks_check do not count: a program's list names them, no application calls them.
few()
{
    grep -v '^tp_\(stage\|store\)_\|^tp_[a-z_]*_enabled$\|^tp_lacks_check$' \
        "$scratch/names" >"$scratch/few"
    find include/tidepool -name '*.h' | cat - "$scratch/few"
    [ "$(find include/tidepool -name '*.h' | wc -l)" -le 8 ] &&
        [ "$(wc -l <"$scratch/few")" -le 50 ]
}
check "there are at most 8 headers and 50 functions" few

# Takes the functions' addresses in C++.
linked()
{
    {
        echo '#include "tidepool/tidepool.h"'
        echo 'static void (*const functions[])() = {'
        sed 's/.*/    (void (*)())&/; s/$/,/' "$scratch/names"
        echo '};'
        echo 'static const void *const constants[] = {'
        sed 's/.*/    \&&,/' "$scratch/constants"
        echo '};'
        echo 'int main(int count, char **) {'
        echo '    return !functions[count] || !constants[count]; }'
    } >"$scratch/linked.cpp"
    g++ -std=c++11 $strict -Iinclude "$scratch/linked.cpp" "$library" -o "$scratch/linked" &&
        "$scratch/linked"
}
check "C++ links every one of them" linked

# Macros give constants in C++ too; header and library have the same version.
constants()
{
    cat >"$scratch/constants.cpp" <<'END'
#include <string.h>
#include "tidepool/tidepool.h"
static_assert(TP_FX(0.5) == 0x8000 && TP_FX(-0.5) == -0x8000, "16.16");
static_assert(TP_Q30(1) == TP_Q30_ONE && TP_DEG(90) == 1u << 30, "Q2.30, angles");
#if TP_VERSION != TP_VERSION_MAJOR * 1000000 + TP_VERSION_MINOR * 1000 + TP_VERSION_PATCH
#error
#endif
constexpr tp_vec3 up = { 0, TP_FX(1), 0 };
int main()
{
    return strcmp(tp_version(), TP_VERSION_TEXT) || tp_fx_mul(up.y, TP_FX(2)) != TP_FX(2);
}
END
    g++ -std=c++11 $strict -Iinclude "$scratch/constants.cpp" "$library" \
        -o "$scratch/constants" && "$scratch/constants"
}
check "constants and versions are C++'s too" constants

# The README's first program in both languages; C++ before 2020 lacks its initialisers.
same_picture()
{
    first_program | tee "$scratch/first.c" >"$scratch/first.cpp"
    gcc -std=c11 $strict -Iinclude "$scratch/first.c" "$library" -o "$scratch/first" &&
        "$scratch/first" >"$scratch/by_c" &&
        g++ -std=c++20 $strict -Wno-missing-field-initializers -Iinclude \
            "$scratch/first.cpp" "$library" -o "$scratch/first" &&
        "$scratch/first" | diff "$scratch/by_c" -
}
check "the README's first program draws one picture in C and C++" same_picture

# The version's numbers stand in the header; the program prints the library's.
version=$(sed -n 's/^#define TP_VERSION_\(MAJOR\|MINOR\|PATCH\) *//p' \
    include/tidepool/tidepool.h | paste -sd.)
written_once()
{
    find . \( -name .git -o -path ./build -o -path ./out -o -name node_modules \
        -o -name '*.png' \) -prune -o -type f -print0 |
        xargs -0 grep -nIwF "$version" && return 1
    "${TP_PROGRAM:-build/host/tidepool}" --version | grep -qx "tidepool $version"
}
check "version $version is written in its header alone" written_once
finish
