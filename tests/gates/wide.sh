#!/bin/sh
# SPDX-License-Identifier: MIT
# Named loops of the pixel stages are vectorised in the build for x86-64-v3, by gcc and by
# clang: wide.txt lists them. The commands are those of make; only reports are added.
. "$(dirname "$0")/../lib/script.sh"

case $(uname -m) in x86_64) ;; *) skip "wide loops" "none: this is no x86-64"; exit 77 ;; esac
list=tests/gates/wide.txt
files_of()      { awk '!/^#/ && NF { print $2 }' "$1" | LC_ALL=C sort -u; }
sources_of()    { awk '!/^#/ && NF { print $NF ~ /\.c$/ ? $NF : $2 }' "$1" | LC_ALL=C sort -u; }

# reports COMPILER FLAG... : the compiler's reports on the list's sources, as make compiles
# them.
reports()
{
    compiler=$1; shift
    build -n V=1 TARGET=wide CC="$compiler" \
        $(sources_of $list | sed 's|\(.*\)c$|build/wide/v3/\1o|') |
        awk -v compiler="$compiler" -v flags="$*" -v to="$scratch/" '
            sub(/\\$/, "") { head = head $0; next }
            { $0 = head $0; head = "" }
            $1 == compiler && / -c / {
                sub(/ -c /, " " flags " -c ")
                sub(/-o [^ ]*$/, "-o " to "a.o")
                print
            }' >"$scratch/$compiler.commands"
    [ "$(wc -l <"$scratch/$compiler.commands")" = "$(sources_of $list | wc -l)" ] &&
        sh -e "$scratch/$compiler.commands" >"$scratch/$compiler.report" 2>&1 ||
        { tail -n 5 "$scratch/$compiler.report"; return 1; }
}
gcc_flags=-fopt-info-vec-optimized-missed
clang_flags='-Rpass=loop-vectorize -Rpass-missed=loop-vectorize'

# wide LIST REPORT
wide()          { awk -f tests/gates/wide.awk "$1" $(files_of "$1") report=1 "$2"; }

# -- what is no wide loop is found ------------------------------------------------------

cat >"$scratch/a.c" <<'END'
#include <stdint.h>
uint32_t next(uint32_t n);

static inline void twice(uint32_t *restrict to, const uint32_t *restrict from, int n)
{
    for (int i = 0; i < n; i++)
        to[i] = from[i] * 2;
}

void both(uint32_t *restrict to, const uint32_t *restrict from, int n)
{
    twice(to, from, n);
    for (int i = 0; i < n; i++)
        to[i] = next(from[i]);
}
END
line()          { echo "a $scratch/a.c $1" >"$scratch/list"; }
v3="-O3 -march=x86-64-v3 -c $scratch/a.c -o $scratch/a.o"

# -- the list ---------------------------------------------------------------------------

for compiler in gcc clang; do
    lacks $compiler $compiler "loops of $compiler" && continue
    [ $compiler = gcc ] && flags=$gcc_flags || flags=$clang_flags
    $compiler $v3 $flags >"$scratch/a.report" 2>&1
    line twice
    check "$compiler: a loop over eight is wide" wide "$scratch/list" "$scratch/a.report"
    line both
    refuse "$compiler: a loop with a call" wide "$scratch/list" "$scratch/a.report"
    line none
    refuse "$compiler: a function that is not there" wide "$scratch/list" "$scratch/a.report"
    check "$compiler compiles the list's files" reports $compiler $flags
    check "$compiler makes each loop of the list wide" wide $list "$scratch/$compiler.report"
done
finish
