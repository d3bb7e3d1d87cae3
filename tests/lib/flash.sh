# SPDX-License-Identifier: MIT
# shellcheck shell=sh disable=SC2034,SC2046,SC2086
# Programs for a Cortex-M4 linked for their size: the library, the compiler's own functions,
# mem* and a baked scene, without a port's code; read by `.` after script.sh.

flash_lib=build/cortex-m4/libtidepool.a
flash_memory=build/cortex-m/ports/cortex-m/memory.o
flash_main=build/cortex-m/ports/cortex-m/main.o
flash_arch="-mcpu=cortex-m4 -mthumb -mfloat-abi=soft"
flash_files='(libtidepool|libgcc)[.]a[(]|/memory[.]o'

flash_sizes=tests/budgets/code-sizes.csv

# Builds the library; false, with a message: no compiler, or not that of the sizes.
flash_ready()
{
    flash_build || return 1
    want=$(sed -n 's/^# compiler m4 //p' $flash_sizes)
    here="${want% *} $(arm-none-eabi-gcc -dumpfullversion)"
    [ "$here" = "$want" ] && return
    skip "flash by $want, here $here" "${want% *}"
    return 1
}
flash_build()   # false, with a message: no compiler
{
    lacks arm-none-eabi-gcc gcc-arm-none-eabi "the flash of programs" && return 1
    build -s BOARD=cortex-m $flash_lib $flash_memory $flash_main >"$scratch/log" 2>&1 ||
        { cat "$scratch/log"; return 1; }
    flash_gcc=$(arm-none-eabi-gcc $flash_arch -print-libgcc-file-name)
}

# The pieces that a list can name, in all variants.
pieces()
{
    arm-none-eabi-nm -g --defined-only $flash_lib | sed -n \
        's/.* T \(tp_\(stage\|store\)_[a-z0-9_]*\)$/\1/p
         s/.* [TR] \(tp_scene_check\|tp_world_steering\|tp_world_init\)$/\1/p
         s/.* R \(tp_\(water\|draw\|method\)_[a-z0-9_]*\)$/\1/p
         s/.* R \(tp_[a-z0-9_]*_\(module\|drawing\)\)$/\1/p' | sort -u
}

# What a port calls of the library, as options of the linker.
flash_calls()
{
    arm-none-eabi-nm -u $flash_main |
        sed -n 's/.*U \(tp_.*\)/-u \1/p'
}

flash_link_alone()      # SYMBOL TO [OBJECT | OPTION]...: links what a symbol reaches
{
    symbol=$1 to=$2
    shift 2
    arm-none-eabi-ld --gc-sections -e "$symbol" -u "$symbol" "$@" $flash_lib \
        $flash_memory $flash_gcc -Map "$to.map" -o "$to.elf"
}

# Links the functions that every program calls, with BAKED.o or without a scene.
flash_link()            # TO [BAKED.o]
{
    set -- "$1" ${2:+-u baked_config -u baked_frame_bytes -u baked_frame_init \
        -u baked_world_init "$2"}
    [ $# -gt 1 ] || set -- "$1" --defsym tp_program_linked=0
    to=$1
    shift
    flash_link_alone tp_frame_maker "$to" $(flash_calls) "$@"
}

# Lines "code BYTES" and "constants BYTES" of the program linked last: of the library, and of
# the functions that make the baked frame and world.
flash_linked()          # MAP BAKED.o
{
    awk -v files="$flash_files" -f tests/budgets/map.awk "$1" |
        awk -v init="$(arm-none-eabi-nm -S -t d "$2" |
            awk '$4 ~ /^baked_(frame_bytes|(frame|world)_init)$/ { n += $2 }
                END { print n }')" '
            { print "code", $1 + init; print "constants", $2 }'
}

# Lines USE BYTES of the table in a baked file's head.
memory_of()             # BAKED.c
{
    sed -n '/^ \* Bytes on a Cortex-M4/,/\*\//s/^ \* *//p' "$1" | awk '
        $1 == "frame" || $1 == "code" { split($0, use, " "); next }
        $1 == "RAM" || $1 == "flash" {
            for (i = 1; i < NF - 1; i++) print use[i], $(i + 1)
        }'
}

flash_of()              # ELF: its bytes
{
    arm-none-eabi-size "$1" | awk 'END { print $1 + $2 }'
}

# Not estimated: fill between sections and the table of unwinding, 32 to 69 bytes as measured.
flash_near()            # ESTIMATE BYTES
{
    awk -v a="$1" -v b="$2" 'BEGIN { off = a > b ? a - b : b - a
        if (b > 0 && off <= 128) exit 0
        print a " is not " b "; code changed? tests/budgets/code-sizes.sh --write"; exit 1 }'
}

# Bakes a program, as scenes-count.sh does, and links it: its bytes.
flash_of_baked()        # SCENE [OPTION]...
{
    "$program" bake "$@" --name baked --size "${size:-320x240}" --format rgb565 --no-input \
        -o "$scratch/baked.c" </dev/null || return 1
    awk -v texels="$scratch/baked-texels.s" -f ports/tools/bake/texels.awk \
        "$scratch/baked.c" >"$scratch/baked-rest.c" &&
        arm-none-eabi-gcc $flash_arch -std=c11 -ffreestanding -O2 -Iinclude \
            -S "$scratch/baked-rest.c" -o "$scratch/baked.s" &&
        cat "$scratch/baked-texels.s" >>"$scratch/baked.s" &&
        arm-none-eabi-gcc $flash_arch -c "$scratch/baked.s" -o "$scratch/baked.o" &&
        flash_link "$scratch/program" "$scratch/baked.o" && flash_of "$scratch/program.elf"
}
