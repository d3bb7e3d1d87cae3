# SPDX-License-Identifier: MIT
# Moves the texels of a baked scene to assembly, which is read twenty times as fast as C:
# prints the C file with the arrays declared only, and writes them to the file `texels`.
# The directives take the byte order of the assembler's machine.
#     awk -v texels=NAME.s -f texels.awk SCENE.c
BEGIN { print ".section .rodata" >texels }
/^static const uint(16|32)_t [a-z0-9_]*\[[0-9]+\] = \{$/ {
    name = $4
    sub(/\[.*/, "", name)
    print ".balign 4\n" name ":" >texels
    directive = $3 == "uint32_t" ? ".4byte" : ".2byte"
    sub(/^static/, "extern")
    sub(/ = \{$/, ";")
    print
    within = 1
    next
}
within && /^};/ { within = 0; next }
within          { sub(/,$/, ""); print directive, $0 >texels; next }
                { print }
