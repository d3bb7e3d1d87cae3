#!/bin/sh
# SPDX-License-Identifier: MIT
# Raspberry Pi boards, emulated: the screen equals the golden frame pixel by pixel, in 32
# and in 16 bits, from the ELF file and from the image for a card; frames reported on the
# serial port equal the host's, also after lines that set the scene's numbers; each fault
# is one clear line. Quick: raspi2b, built at -O1. With TP_SOAK set all boards, built at -O2
# as they are for use.
#     rpi.sh [PROGRAM]
. "$(dirname "$0")/../lib/script.sh"

program=${1:-build/host/tidepool}
scene=three-swells
size='width 208 height 150'     # size of golden frames
set=wave0.amplitude
level=${TP_SOAK:+-O2} level=${level:--O1}
same=build/host/tests/boards/same_picture

# board | emulator | triple | option that loads a card's image at the firmware's address
loader='-device loader,force-raw=on,cpu-num=0,addr=0x8000,file=@'
boards="${TP_SOAK:+raspi0 | arm | arm-none-eabi | $loader
raspi3b | aarch64 | aarch64-linux-gnu | -kernel @}
raspi2b | arm     | arm-none-eabi     | $loader
"

alone build -s $same >/dev/null || exit 1

# -- output and pictures of the boards ---------------------------------------------------

# heard WORDS: waits for the words, or for the emulator's end, at most ten seconds.
heard()
{
    for i in $(seq 200); do
        ! grep -q "$1" "$name.said" 2>/dev/null && [ ! -e "$name.code" ] || break
        sleep 0.05
    done
}

# emulate NAME WORDS LINES UNTIL OPTION...: runs with WORDS as a command line, if any, and
# LINES for the serial port; dumps the screen when UNTIL has been printed. Writes
# NAME.said, .ppm and .code.
emulate()
{
    name=$scratch/$board-$1 words=$2 lines=$3 until=$4
    shift 4
    {
        [ -z "$lines" ] || heard "^screen"
        printf "$lines"
        heard "$until"
        printf '\001c'                          # switches to the monitor
        echo "screendump $name.ppm"
        echo quit
    } | {
        timeout 20 "qemu-system-$emulator" -M "$board" -display none -serial mon:stdio \
            ${words:+-semihosting-config} \
            ${words:+"enable=on,target=native,arg=tidepool,arg=$words"} \
            "$@" >"$name.said" 2>&1
        echo $? >"$name.code"
    }
}

# broken BYTES: the ELF file with these bytes at the beginning of main.
broken()
{
    at=$("$triple-readelf" -SW "$elf" | awk '/ \.text / {
        for (i = 1; i <= NF; i++) if ($i == "PROGBITS") print $(i + 1), $(i + 2) }')
    main=$("$triple-nm" "$elf" | awk '$3 == "main" { print $1 }')
    cp "$elf" "$scratch/$board-broken.elf"
    printf "$1" | dd of="$scratch/$board-broken.elf" bs=1 conv=notrunc 2>/dev/null \
        seek=$((0x$main - 0x${at% *} + 0x${at#* }))
}

run_board()
{
    elf=build/$board/scenes/$scene.elf
    "$triple-objcopy" -O binary "$elf" "$scratch/$board.img"
    case $board in      # an undefined instruction; main pushes registers and calls itself
    raspi3b) undefined='\0\0\0\0' deeper='\375\173\277\251\377\377\377\27' ;;
    *)       undefined='\360\0\360\347' deeper='\377\137\55\351\375\377\377\352' ;;
    esac
    emulate 32 "depth 32 $size first 100 frames 1" '' '^frame 0100' -kernel "$elf"
    emulate 16 "depth 16 $size first 99 frames 2" '' '^frame 0100' $card
    emulate set "$size frames 1" "set $set 0.9\nset $set 99\nstep 10\nstate\n" \
        "^ok tick" -kernel "$elf"
    emulate alone '' 'pause\nstep 2\nstate\n' '^ok tick' -kernel "$elf"
    emulate wide 'depth 32 width 4000 height 16 frames 1' '' halted -kernel "$elf"
    emulate depth 'depth 12 frames 1' '' halted -kernel "$elf"
    emulate large 'width 3824 height 1280 frames 1' '' halted -kernel "$elf" \
        -global bcm2835-fb.vcram-size=33554432
    broken "$undefined"
    emulate undefined 'frames 1' '' halted -kernel "$scratch/$board-broken.elf"
    emulate halted '' '' halted -kernel "$scratch/$board-broken.elf"
    broken "$deeper"
    emulate deeper 'frames 1' '' halted -kernel "$scratch/$board-broken.elf"
}

# -- expected output and pictures --------------------------------------------------------

for format in xrgb8888 rgb565; do
    "$program" render $scene --rung named --size 208x150 --frames 99:100 --format $format \
        --out "$scratch/$format-%d.png" || exit 1
done
"$program" render $scene --rung named --size 208x150 --frames 10:10 --set $set=0.9 --hash \
    --out "$scratch/set.png" >"$scratch/set" || exit 1

said()          # RUN LINE: a whole line
{
    tr -d '\r' <"$scratch/$board-$1.said" | grep -qx "$2" || {
        sed '/QEMU/,$d' "$scratch/$board-$1.said"
        return 1
    }
}
ended()         # RUN CODE
{
    [ "$(cat "$scratch/$board-$1.code")" = "$2" ]
}
golden()        # FORMAT: the golden line of frame 100
{
    grep '^frame 0100 ' tests/golden/$scene/$1.crc
}
other()         # PICTURE OTHER [565]: both exist, and they differ
{
    $same "$@"
    [ $? = 1 ]
}
# The last frame drawn without requests, and two steps, equal the host's at that tick.
by_itself()
{
    frame=$(grep -a '^frame' "$scratch/$board-alone.said" | tail -n 1 | tr -d '\r')
    tick=$(echo "$frame" | sed 's/frame 0*\([0-9]*\) .*/\1/')
    [ "$tick" -ge 2 ] && "$program" render $scene --rung named --frames "$tick:$tick" --hash |
        grep -x "$frame"
}

# The firmware of a real Raspberry Pi 2 starts the processor in hypervisor mode; the
# emulated board does not, but the Cortex-A7 of another emulated machine does.
hypervisor()
(
    name=$scratch/hypervisor
    symbols=$(printf ',--defsym=%s=0x40800000' stack_top fault_stack reset fault)
    arm-none-eabi-gcc -nostdlib -Wl,-e,_start,-z,noexecstack$symbols \
        -Wl,--section-start=.start=0x40010000 build/raspi2b/ports/rpi/entry.o \
        -o "$name.elf" && arm-none-eabi-objcopy -O binary "$name.elf" "$name.img" ||
        return 1
    (heard 'hyp to svc'; echo quit) | timeout 20 qemu-system-arm -cpu cortex-a7 \
        -M virt,virtualization=on -display none -serial none -monitor stdio \
        -d int -D "$name.said" -kernel "$name.img"
    grep 'hyp to svc' "$name.said"
)

check_board()
{
    check "$board tells the golden frame of 32 bits" said 32 "$(golden xrgb8888)"
    check "$board tells the golden frame of 16 bits" said 16 "$(golden rgb565)"
    check "$board shows it, 32 bits a pixel" \
        $same "$scratch/$board-32.ppm" "$scratch/xrgb8888-100.png"
    check "$board shows it from a card's image, 16 bits a pixel" \
        $same "$scratch/$board-16.ppm" "$scratch/rgb565-100.png" 565
    check "$board does not show another frame" \
        other "$scratch/$board-32.ppm" "$scratch/xrgb8888-99.png"
    check "$board does not show another frame of 16 bits" \
        other "$scratch/$board-16.ppm" "$scratch/rgb565-99.png" 565
    check "$board takes a number" said set "ok $set = 0.9 m"
    check "$board refuses a number" said set "error $set = 99 is outside 0..16 m"
    check "$board tells what that number makes" said set "$(cat "$scratch/set")"
    check "$board shows it" $same "$scratch/$board-set.ppm" "$scratch/set.png"
    check "$board moves on by itself, and stops" by_itself
    check "$board has no screen of 4000 pixels" \
        said wide 'no frame buffer: asked for size 4000 16, got 3840 16'
    check "$board says so to who started it" ended wide 3
    check "$board has no screen of 12 bits" \
        said depth 'no frame buffer: the depth is 16 or 32'
    check "$board stops at that" ended depth 3
    check "$board has no memory for two pages of 3824x1280" \
        said large 'no frame buffer: too little memory'
    check "$board does not try" ended large 3
    check "$board tells of an undefined instruction" \
        said undefined 'fault: undefined instruction, pc 0*[0-9a-f]* address 0*'
    check "$board ends with 2" ended undefined 2
    check "$board halts where nobody listens" said halted 'halted 2'
    check "$board finds its stack overflown" \
        said deeper 'fault: no such data, pc 0*[0-9a-f]* address 03b[0-9a-f]*'
    check "$board ends with 2 then" ended deeper 2
}

tried=
while IFS='|' read -r board emulator triple card; do
    board=$(echo $board) emulator=$(echo $emulator) triple=$(echo $triple)
    card=$(echo "$card" | sed "s,@,$scratch/$board.img,")
    [ -n "$board" ] || continue
    lacks "qemu-system-$emulator" qemu-system-arm "$board" && continue
    lacks "$triple-gcc" "gcc-$triple" "$board" && continue
    check "$board builds" alone build OPT=$level BOARD=rpi/"$board" SCENE=$scene elf
    [ "$board" != raspi2b ] || check "$board gives up being a hypervisor" hypervisor
    run_board &
    tried="$tried $board"
done <<EOF
$boards
EOF
wait
for board in $tried; do
    check_board
done
finish
