#!/bin/sh
# SPDX-License-Identifier: MIT
# /dev/fb0 of a Debian kernel on an emulated PC, with 8, 15, 16, 24, 32 bits a pixel: the
# screen, dumped from outside of the machine, equals the golden frame and the host's
# picture, pixel by pixel.
#
#   tests/boards/linuxfb.sh [PROGRAM]
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/board.sh"

program=${1:-build/host/tidepool}
scene=three-swells screen=build/host/scenes/three-swells-screen
golden=tests/golden/$scene

vm_lacks "screens of /dev/fb0" amd64 && exit 0
check "one static file shows a scene" alone build "$screen"
[ "$failed" = 0 ] || exit 1
exits()         # CODE WORDS ARGUMENT...: that file on this machine, which has no screen
{
    want=$1 words=$2
    shift 2
    "$screen" "$@" >"$scratch/said" 2>&1 </dev/null
    code=$?
    cat "$scratch/said"
    [ $code = "$want" ] && grep -q -e "$words" "$scratch/said"
}
check "it tells what it takes" exits 0 "--keep FILE" --help
check "an option that it does not know is a usage error" exits 2 "unknown option" --sice 64x48
check "a device that is not there is none" exits 4 "No such file" --device /nowhere
check "one that is no screen is none" exits 4 "is not a frame buffer" --device /dev/null

cat >"$scratch/cases" <<'EOF'
show whole three-swells-screen --on fb --frames 3:3
show golden three-swells-screen --on fb --frames 100:100 --size 208x150
three-swells-screen --on fb --size 641x480 2>/tmp/said
check "what is larger than the screen is refused" ended 4 $? "smaller than the picture"
EOF

# mode | VESA's number | best format for the mode | significant bits a channel; with
# TP_SOAK all, else p8 and 32
while IFS='|' read -r mode number format bits; do
    mode=$(echo $mode) format=$(echo $format) bits=$(echo $bits)
    case ${TP_SOAK:-}$mode in
    555|565|24) continue ;;
    esac
    "$program" render $scene --rung named --size 640x480 --frames 3:3 --format $format \
        --out "$vm_work/$mode.png" >"$scratch/output" || cat "$scratch/output"
    vm_want $mode-whole "$vm_work/$mode.png" $bits
    vm_want $mode-golden $golden/$format-0100.png $bits centred
    vm_disk $mode amd64 "$scratch/cases" "" "$screen"
    check "$mode: the machine boots" \
        vm_boot $mode amd64 "vga=$number boot=$mode" -vga std
    vm_results $mode
    check "$mode: the host's picture on the whole screen" vm_same $mode-whole
    check "$mode: the golden frame in its middle" vm_same $mode-golden
done <<EOF
p8  | 0x301 | p8       | 666
555 | 0x310 | xrgb8888 | 555
565 | 0x311 | rgb565   | 565
24  | 0x312 | xrgb8888 | 888
32  | 0x342 | xrgb8888 | 888
EOF

vm_want 32-golden $golden/xrgb8888-0000.png 888 centred
refuse "another frame than the golden one is found" vm_same 32-golden
dump=$vm_work/32-whole.ppm
{
    head -c 600000 "$dump"
    tail -c +600001 "$dump" | head -c 1 | tr "\000-\377" "\001-\377\000"
    tail -c +600002 "$dump"
} >"$scratch/one" && mv "$scratch/one" "$dump"
refuse "one pixel that differs by one is found" vm_same 32-whole
finish
