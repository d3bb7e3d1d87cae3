#!/bin/sh
# SPDX-License-Identifier: MIT
# Exact instructions per water pixel of the pictures of span.h, as rows of the sweep.
#
#   tests/charts/span.sh m4|x86 span|filter SCENE
#
# "filter" counts the water stages.  "span" counts the spans of the triangles, with the
# reciprocals beyond the affine spans, and the whole picture as frame_m4.
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/board.sh"

column=$1 chart=$2 scene=$3
case $column in
m4)
    built=build/cortex-m core=build/cortex-m4 nm=arm-none-eabi-nm
    emulate "build/cortex-m/span-$scene.elf" "$scratch/said" "$scratch/counts" ;;
x86)
    # QEMU 7.2 fails at gather instructions of newer processors.
    built=build/host core=build/host nm=nm
    qemu-x86_64 -cpu Nehalem -plugin $plugin "build/host/tests/charts/span-$scene" \
        >"$scratch/said" 2>"$scratch/counts" ;;
*)
    echo "usage: span.sh m4|x86 span|filter SCENE" >&2; exit 2 ;;
esac || { cat "$scratch/said" >&2; exit 1; }

case $chart in
span) $nm "$built"/tests/charts/span_step_*.o ;;
*)    $nm "$core"/src/shade/*.o "$core"/src/features/*/*_stage.o | grep -v ' tp_stage_sky' ;;
esac | awk '$2 ~ /[tT]/ { print "of", $3 }' >"$scratch/of"
[ -s "$scratch/of" ] || { echo "span.sh: no functions to count" >&2; exit 1; }
awk -v column="$column" -v chart="$chart" -v scene="$scene" '
    function point(i)
    {
        return from[i] == "-" ? scene ";" key[i] : key[i]
    }
    # The affine row of the same scene: the base for the count of reciprocals.
    function base(i,    k)
    {
        for (k = i; of[k] == chart && from[k] == from[i]; k++)
            if (key[k] ~ /affine$/)
                return other[k]
        return 0
    }
    function say(i, name, value)
    {
        if (water[i] == 0) {
            print "span.sh: no water in " point(i) > "/dev/stderr"
            exit 1
        }
        printf "%s,%s,%s,%.2f\n", chart, point(i), name, value / water[i]
    }
    $1 == "of"  { ours[$2]; next }
    $1 == "run"  { n++; of[n] = $2; from[n] = $3; key[n] = $4; water[n] = $5; next }
    $1 != "count" || $4 ~ /^tp_tri_[a-z]*$/ { next }
    { all[$2] += $5 }
    $4 in ours { own[$2] += $5 }
    $4 == "tp_recip_norm" { other[$2] += $5 }
    END {
        for (i = 1; i <= n; i++) {
            if (of[i] != chart || (from[i] != "-" && from[i] != scene))
                continue
            said++
            say(i, column, own[i] + (chart == "span" ? other[i] - base(i) : 0))
            if (chart == "span" && column == "m4")
                say(i, "frame_m4", all[i])
        }
        if (!said)
            print "span.sh: nothing was counted of " chart > "/dev/stderr"
        exit !said
    }' "$scratch/of" "$scratch/said" "$scratch/counts"
