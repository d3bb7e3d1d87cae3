# SPDX-License-Identifier: MIT
# Compares the pieces that a program links with its baked list; read after
# tests/gates/lib.sh.

# pieces_of ELF: modules, passes, stages, wave models, systems, parts and renderers.
pieces_of()
{
    arm-none-eabi-nm --defined-only "$1" | sed -n \
        's/.* [A-Za-z] \(tp_\(stage\|water\|move\|draw\|method\)_[a-z0-9_]*\)$/\1/p
         s/.* [Rr] \(tp_[a-z0-9_]*_\(module\|drawing\)\)$/\1/p' | sort -u
}

# listed BAKED.c: pieces named by its list.
listed()
{
    grep -o 'tp_[a-z0-9_]*' "$1" | sort -u
}

# links_no_more PIECES BAKED.c: each linked piece is listed, and at least one is linked.
links_no_more()
{
    listed "$2" >"$1.listed"
    [ -s "$1" ] && ! comm -23 "$1" "$1.listed" | grep .
}
