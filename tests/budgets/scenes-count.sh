#!/bin/sh
# SPDX-License-Identifier: MIT
# Each shipped scene on an emulated Cortex-M4, linked by the list that bake writes for the
# scene: its frames must equal the host's, no piece outside of the list may be linked, and
# the costs in instructions by stage, RAM and stack are compared with scenes.csv.
#
#   tests/budgets/scenes-count.sh [--write] [SCENE...]
#
# Without names every second scene is counted, in turn exact or at its cheapest rungs;
# --write and TP_SOAK=1 count both of each, and the effects of effects.txt. For named scenes the
# functions are listed too. SCENE+cheap is the scene at the rungs of
# tests/budgets/cheapest.txt. --write writes a new scenes.csv.
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/board.sh"

budgets=tests/budgets/scenes.csv
write=
skip=
[ "${1:-}" = --write ] && write=1 && shift
case ${1:-} in */tidepool) shift ;; esac        # tests/run.sh passes the program
program=${TP_PROGRAM:-build/host/tidepool}
whole= table=
if [ $# = 0 ]; then
    table=1
    set -- $(build -s list-scenes)
    if [ -n "$write$TP_SOAK" ]; then    # each scene exact and at its cheapest rungs
        whole=1
        set -- $(for scene; do echo "$scene" "$scene+cheap"; done) \
            plain-64 plain-64+cheap plain-100 plain-100+cheap \
            $(sed -n 's/^\([a-z0-9-]*+[a-z0-9-]*\) .*/\1/p' tests/budgets/effects.txt)
    else            # quicker: of every second scene, in turn exact or at its cheapest
        set -- $(for scene; do echo "$scene"; done | sed -n 'p;n' |
                 sed 'n;s/$/+cheap/') plain-64+cheap
    fi
fi

lacks arm-none-eabi-gcc gcc-arm-none-eabi "scenes on a Cortex-M4" && exit 77
lacks qemu-system-arm qemu-system-arm "scenes on a Cortex-M4" && exit 77

check "the plugin builds" build $plugin
check "the programs for the board build" build BOARD=cortex-m SCENES="$*" elves
[ "$failed" = 0 ] || exit 1

# -- one scene; scenes run in parallel ------------------------------------------------

options_of()    # SCENE: the options of its rungs
{
    case $1 in
    *+cheap) sed -n "s/^${1%+cheap} //p" tests/budgets/cheapest.txt ;;
    *+*)     sed -n "s/^$1 .*| //p" tests/budgets/effects.txt ;;
    esac
}

file_of()       # SCENE
{
    case $1 in
    plain-*) echo "tests/budgets/${1%+*}.ini" ;;
    *)       echo "assets/scenes/${1%+*}.ini" ;;
    esac
}

one()           # SCENE: its figures, or the reason why there are none
{
    elf=build/cortex-m/scenes/$1.elf
    to=$scratch/$1
    emulate "$elf" "$to.said" "$to.counts" || { cat "$to.said"; return 1; }
    # shellcheck disable=SC2046
    "$program" render "$(file_of "$1")" --size 320x240 --frames 60:61 \
        --format rgb565 --hash $(options_of "$1") >"$to.host" || return 1
    grep '^frame' "$to.said" | diff "$to.host" - || return 1
    pieces_of "$elf" >"$to.pieces"
    links_no_more "$to.pieces" "build/cortex-m/baked/$1.c" || return 1
    arm-none-eabi-nm -t d -n -l --defined-only "$elf" >"$to.symbols"
    awk -v scene="$1" -f tests/lib/symbol_at.awk \
        -f tests/budgets/stages.awk "$to.symbols" "$to.said" "$to.counts" |
        LC_ALL=C sort >"$to.figures"
    [ -n "$table" ] || awk -v scene="$1" -v functions=1 \
        -f tests/lib/symbol_at.awk -f tests/budgets/stages.awk \
        "$to.symbols" "$to.said" "$to.counts" >"$to.functions"
}
waited=
for scene; do
    one "$scene" >"$scratch/$scene.log" 2>&1 &
    waited="$waited $!:$scene"
    if [ "$(echo "$waited" | wc -w)" -ge "$(nproc)" ]; then
        first=${waited# } first=${first%% *} waited=${waited#* $first}
        check "${first#*:} draws on the board as here" wait "${first%%:*}"
    fi
done
for first in $waited; do
    check "${first#*:} draws on the board as here" wait "${first%%:*}"
done

# -- all scenes -----------------------------------------------------------------------

for scene; do
    [ -f "$scratch/$scene.functions" ] && cat "$scratch/$scene.functions"
    [ -s "$scratch/$scene.figures" ] || { cat "$scratch/$scene.log"; continue; }
    cat "$scratch/$scene.figures" >>"$scratch/figures"
done
if [ -n "$table" ]; then
    arm-none-eabi-size -A build/cortex-m4/libtidepool.a | awk '
        /^\.text/   { text += $2 }
        /^\.rodata/ { constants += $2 }
        END { print "figure core text-bytes", text
              print "figure core constant-bytes", constants }' >"$scratch/core"
    cat "$scratch/core" >>"$scratch/figures"
fi
[ "$failed" = 0 ] || exit 1
grep -v '^figure core' "$scratch/figures" | awk -f tests/budgets/scenes.awk $budgets -
[ -z "$table" ] || awk '{ printf "%s%s %s %d", (NR > 1 ? ", " : ""), $2, $3, $4 }
                        END { print "" }' "$scratch/core"
if [ -n "$write" ]; then
    rewrite $budgets m4=arm-none-eabi-gcc
    exit
fi
pinned $budgets m4 arm-none-eabi-gcc && hold $budgets
finish
