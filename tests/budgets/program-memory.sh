#!/bin/sh
# SPDX-License-Identifier: MIT
# The RAM and flash that `tidepool bake` and `tidepool plan` print before anything is linked,
# against the linked programs of all shipped scenes: netduinoplus2's, on a machine with the
# same processor and memory enough for all. Code and constants are those of the library in
# the linker's map, without what only the checksums of the port call; pictures are those of the
# baked object, RAM is what the running program says.
# Prints the largest difference of each, which is 2 % at most; `placed` is RAM without stack.
#
#   tests/budgets/program-memory.sh [PROGRAM [SCENE]...]
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/board.sh"
. "$(dirname "$0")/../lib/flash.sh"

program=${TP_PROGRAM:-${1:-build/host/tidepool}}
[ $# = 0 ] || shift
size="$(sed -n "s/^BAKE *:= \(.*\) --no-input/\1/p" \
    ports/cortex-m/netduinoplus2/board.mk) --texels 64"
built=build/large
for tool in arm-none-eabi-gcc:gcc-arm-none-eabi qemu-system-arm:qemu-system-arm; do
    lacks "${tool%:*}" "${tool#*:}" "memory of programs" && exit 77
done

# shellcheck disable=SC2046
[ $# -gt 0 ] || set -- $(basename -s .ini assets/scenes/*.ini)

# Lines USE BYTES of a scene.
baked()         # SCENE
{
    memory_of "$built/baked/$1@64.c"
}
planned()       # SCENE
{
    # shellcheck disable=SC2086
    "$program" plan "$1" $size --csv | awk -F, '/^(ram|flash),/ { print $2, $4 }'
}
# The same of the linked program that has run.
linked()        # SCENE
{
    flash_link "$scratch/program" "$built/baked/$1@64.o"
    flash_linked "$scratch/program.map" "$built/baked/$1@64.o"
    arm-none-eabi-nm -S -t d "$built/baked/$1@64.o" | awk '
        NF == 4 && $4 !~ /^baked_(frame_bytes|(frame|world)_init|direct_scratch_bytes)$/ {
            rest = $4 ~ /^baked_(scene|assets|program|config|modules|lacks|boat|.*_stages)$/ ||
                $4 ~ /^baked_boat_(materials|vertices|faces)$/ || $4 !~ /^baked_/ ||
                $4 ~ /^baked_(tables|coastal|(world|frame)(_.*)?|stencil|scratch_bytes)$/ ||
                $4 ~ /^baked_(gradient|shine|tones|dome|light|ripples|rows)(_of)?$/
            sum[rest] += $2
        }
        END { print "pictures", sum[0] + 0; print "scene", sum[1] }'
    awk '$1 == "ram" {
        for (i = 2; i < NF; i += 2) value[$i] = $(i + 1)
        placed = value["frame"] + value["scratch"] + value["world"]
        print "placed", placed
        print "ram", placed + value["stack"]
    }' "$scratch/$1.said"
}
with_sums()     # adds lines of sums to lines USE BYTES
{
    awk '{ print; if ($1 !~ /^(code|constants|scene|pictures)$/) ram += $2; stack[$1] = $2 }
        END { print "placed", ram - stack["stack"]; print "ram", ram }'
}
runs()          # SCENE
{
    emulate "$built/scenes/$1@64.elf" "$scratch/$1.said" /dev/null
}
# near FILE FILE: the uses of the second within 2 % of the first; prints the differences
near()
{
    awk -v room="$room" '
        FNR == NR { value[$1] = $2; next }
        $1 in value {
            off = $2 ? 100 * value[$1] / $2 - 100 : value[$1]
            printf "%s %+.2f\n", $1, off
            seen++
            if (off > room || off < -room) bad = 1
        }
        END { exit bad || seen != 6 }' "$1" "$2"
}
room=2
# shellcheck disable=SC2086
check "programs of $# scenes link" build BOARD=cortex-m/netduinoplus2 TARGET=large \
    BOARD_LD=ports/cortex-m/board.ld $(printf "$built/scenes/%s@64.elf " "$@")
[ $failed = 0 ] || exit 1
flash_ready || { finish; exit; }
for scene; do
    check "$scene: its program runs" runs "$scene"
    linked "$scene" >"$scratch/linked"
    for by in baked planned; do
        $by "$scene" | with_sums >"$scratch/$by"
        check "$scene: memory as $by" near "$scratch/$by" "$scratch/linked"
        sed "s/^/$scene /" "$scratch/output" >>"$scratch/off-$by"
    done
done
awk '{ $2 *= 1.05; print }' "$scratch/linked" >"$scratch/other"
refuse "5 % more is found" near "$scratch/other" "$scratch/linked"
for by in baked planned; do
    echo "largest differences, as $by:"
    awk '{ size = $3 < 0 ? -$3 : $3 }
        !($2 in most) || size > most[$2] { most[$2] = size; line[$2] = $0 }
        END { for (use in line) print "    " line[use] " %" }' "$scratch/off-$by" | sort -k2
done
finish
