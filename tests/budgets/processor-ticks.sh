#!/bin/sh
# SPDX-License-Identifier: MIT
# Prints the instructions of a tick's work on a Cortex-M4 and on a Cortex-M0+, and the factors
# that ports/app/scene/tick_cost.c takes: tick 60 of a scene with the work, less the tick
# without it.
#
#   tests/budgets/processor-ticks.sh
. "$(dirname "$0")/../lib/script.sh"

build processor-tools >/dev/null || exit 1

ticks()         # PROCESSOR: of a line's scene; without "-": nothing is taken away
{
    tests/charts/board.sh "$1" "$scene" 32x24 60 "$with" "${without#-}" |
        awk -v whole="$without" '
            { tick[NR] = $6 } END { print tick[1] - (whole == "-" ? 0 : tick[2]) }'
}
while IFS='|' read -r work scene with without; do
    echo "$work|$scene|$(ticks m4)|$(ticks m0)"
done <<'WORKS' | awk -F'|' '{ printf "%-14s %-10s %9d %9d  %.2f\n", $1, $2, $3, $4, $4 / $3 }'
cells|pond|field.cols=0|-
sponge|tank||-
sponge|harbour|foam.cells=0|-
wide|tank|pool.cell_bits=32|-
wide|pond|field.cols=0 pool.cell_bits=32|-
drive|pond||field.drive_min=0
visits|harbour||foam.cells=0
deep|storm||foam.crest=0
deep wave|storm||wave5.amplitude=0
coastal wave|deep-sea||wave5.amplitude=0
coastal wave|shore-break||wave1.amplitude=0
map wave|shallows||wave1.amplitude=0
WORKS
