#!/bin/sh
# SPDX-License-Identifier: MIT
# Gates on this machine's object code.
. "$(dirname "$0")/../lib/script.sh"

stack_limit=4224        # boards: 4096 (arm.sh); pointers of 64 bits take more

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
            -Werror -Wall -c "$file" -o "$scratch/interact-$(basename "$file" .c).o" || return 1
    done
    nm "$scratch"/interact-*.o | awk '
        NF == 3 { defined[$3] = 1 }
        $1 == "U" { called[$2] = 1 }
        END {
            for (name in called)
                if (!(name in defined) && name !~ /^(mem(cpy|set)|tp_[a-z0-9_]*)$/) {
                    print name; bad = 1
                }
            exit bad
        }' &&
        size "$scratch"/interact-*.o | awk 'NR > 1 && $2 + $3 > 0 { print; bad = 1 }
            END { exit bad }'
}
check "what interactive ports share is freestanding, and has no memory of its own" shared
finish
