#!/bin/sh
# SPDX-License-Identifier: MIT
# Gates on the sources and on this machine's object code.
. "$(dirname "$0")/../lib/script.sh"

stack_limit=4096
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

check "includes point down" awk -f $gates/layers.awk $(core_files) $(port_files)
check "a feature is known in its folder alone" \
    awk -f $gates/features.awk $(core_files | grep '\.[ch]$')
check "the core keeps to its words" awk -f $gates/words.awk $(core_files)
check "every file has its licence line, and no line is too long" \
    awk -f $gates/text.awk $(every_file)

contracts() { awk "$@" -f $gates/asserts.awk $(core_files | grep '^src/'); }
check "asserts have no effect: $(contracts | sed -n 's/^core *//p')" contracts
check "5 to 10 of them in a thousand lines" contracts -v least=5 -v most=10

listed()        # the Makefile's list of core files equals the folder's content
{
    build -s list-core | tr ' ' '\n' | sort >"$scratch/listed"
    find src -name '*.c' | sort | diff "$scratch/listed" -
}
check "the Makefile lists every file of the core" listed

# Compiled for general registers only: floating point is then an error, or a call of the
# compiler's soft-float library, which the gate on symbols finds.
whole=build/gates/libtidepool.a
compiled()
{
    build TARGET=gates ARCH='-mgeneral-regs-only -fno-pie' \
        OPT='-O2 -fstack-usage -fcallgraph-info=su' $whole
}
check "the core compiles without floating-point registers" compiled
check "the core asks for nothing but mem* and helpers" symbols "" $whole
check "the core has no mutable state" no_state "" $whole
check "no recursion, and a stack below $stack_limit bytes" \
    no_deeper $stack_limit $(find build/gates/src -name '*.ci')
case $(uname -m) in
x86_64)
    check "no floating point in the optimised library" \
        no_floats "${TP_BUILD:-build/host}/libtidepool.a" ;;
esac

# Ports shared by pages and boards: no heap, no files, no floats either.
shared()
{
    for file in ports/interact/*.c; do
        cc -std=c11 -O2 -ffreestanding -mgeneral-regs-only -fno-pie -Iinclude -Isrc \
            -Werror -Wall -c "$file" -o "$scratch/live-$(basename "$file" .c).o" || return 1
    done
    nm -u "$scratch"/live-*.o | awk '
        NF == 2 && $2 !~ /^(mem(cpy|set)|tp_[a-z0-9_]*)$/ { print; bad = 1 }
        END { exit bad }' &&
        size "$scratch"/live-*.o | awk 'NR > 1 && $2 + $3 > 0 { print; bad = 1 }
            END { exit bad }'
}
check "what live ports share is freestanding, and has no memory of its own" shared
finish
