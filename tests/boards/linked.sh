# SPDX-License-Identifier: MIT
# What a program links of the pieces that a list may name, against its baked list; read
# after tests/gates/lib.sh.

# pieces_of ELF: modules, drawings, stages, wave models, movers, parts and methods.
pieces_of()
{
    arm-none-eabi-nm --defined-only "$1" | sed -n \
        's/.* [A-Za-z] \(tp_\(stage\|water\|move\|draw\|method\)_[a-z0-9_]*\)$/\1/p
         s/.* [Rr] \(tp_[a-z0-9_]*_\(module\|drawing\)\)$/\1/p' | sort -u
}

# listed BAKED.c: those that its list names.
listed()
{
    grep -o 'tp_[a-z0-9_]*' "$1" | sort -u
}

# links_no_more PIECES BAKED.c: each piece that is linked is listed; there are some.
links_no_more()
{
    listed "$2" >"$1.listed"
    [ -s "$1" ] && ! comm -23 "$1" "$1.listed" | grep .
}
