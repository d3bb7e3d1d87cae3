#!/bin/sh
# SPDX-License-Identifier: MIT
# Cost of the dearest frame of random views over the median: exact instructions of whole
# frames at 320x240, by QEMU's user mode. A view counts if a tenth of it is water.
#
#   tests/bench/views.sh [PROGRAM [SCENE[,NAME=VALUE]...]...]
#
# TP_VIEWS of each scene, 80 or with TP_SOAK 200; TP_SEED sets the places. A case fails
# above TP_MOST (4) times the median. PROGRAM is given to each test and is not used here.
. "$(dirname "$0")/../lib/script.sh"

views=${TP_SOAK:+200}
views=${TP_VIEWS:-${views:-80}}
[ $# -gt 0 ] && shift
[ $# -gt 0 ] || set -- count-64 three-swells,boat.mesh= three-swells
build=${TP_BUILD:-build/host}
case $(uname -m) in
x86_64) call=110 ;;
*)      call=173 ;;     # newer Linux architectures
esac
emulator=qemu-$(uname -m)
lacks "$emulator" qemu-user "random views" && exit 77
# The program for any x86-64: QEMU 7.2 fails on gathers of the v3 program.
[ "$emulator" != qemu-x86_64 ] || emulator="$emulator -cpu Nehalem"

for scene in "$@"; do
    settings=$(echo "$scene" | tr ',' ' ') name=${scene%%,*}
    # shellcheck disable=SC2086
    TP_COUNTED=1 $emulator -plugin "build/host/tally.so,call=$call" \
        "$build/tests/bench/views" "assets/scenes/$name.ini" "$views" "${TP_SEED:-1}" \
        320 240 ${settings#"$name"} >"$scratch/all" 2>&1 ||
        { cat "$scratch/all"; exit 1; }
    awk '$1 == "insns" { before = last; last = $2 }
         $1 == "view"  { print last - before, $3, $4, $5, $6, $7, $8 }' "$scratch/all" |
        sort -n >"$scratch/views"
    check "$scene: no view costs ${TP_MOST:-4} medians" \
        awk -v most="${TP_MOST:-4}" -f tests/bench/views.awk "$scratch/views"
    sed 's/^/    /' "$scratch/output"
done
finish
