#!/bin/sh
# SPDX-License-Identifier: MIT
# The whole program of ports/README.md, with its callbacks for each vendor's functions.  The
# functions are stand-ins.  The program shows the right picture on a model of the panel.
. "$(dirname "$0")/../lib/script.sh"

page=ports/README.md
program=${TP_PROGRAM:-build/host/tidepool}
warn="-std=c11 -Wall -Wextra -Wno-unused-parameter -Wno-unused-variable -Werror"

code()          # HEADING FROM: the code block with FROM after a heading
{
    awk -v heading="$1" -v from="$2" '
        /^#/ { within = index($0, heading) > 0 }
        within && /^    / && index($0, from) { on = 1 }
        within && on && /^[^ ]/ { exit }
        within && on { print substr($0, 5) }' $page
}

made()          # NAME HEADING FROM: a program of the example and one vendor's callbacks
{
    {
        echo '#include "lcd/lcd.h"'
        echo "#include \"tests/boards/sdk/$1.h\""
        code "$2" "$3"
        echo 'static void pause(void *user, uint32_t ms) { (void)user; PAUSE(ms); }'
        echo 'extern const lcd_wires board_wires;'
        echo 'const lcd_wires board_wires = { NULL, command, data, wait_for, pause };'
    } >"$scratch/$1.c"
    # shellcheck disable=SC2086
    cc $warn -Iinclude -Iports -I. "$scratch/$1.c" "$scratch/example.o" "$scratch/scene.o" \
        "$scratch/readme.o" "$scratch/lcd_panel.o" "$scratch/lcd.o" "$scratch/panels.o" \
        build/host/libtidepool.a -o "$scratch/$1"
}

# Three frames replace the endless loop.
example()
{
    code "The worked example" '#include "lcd/lcd.h"' |
        sed -e 's/for (;;)/for (int n = 0; n < 3; n++)/' \
            -e 's/^int main(void)/int example(void);\nint example(void)/' \
            -e 's/^}$/    return 0;\n}/' >"$scratch/example.c"
    grep -q 'n < 3' "$scratch/example.c" || return 1
    # shellcheck disable=SC2086
    cc $warn -Iinclude -Iports -c "$scratch/example.c" -o "$scratch/example.o"
}

ready()
{
    command=$(code "The worked example" "tidepool bake" | sed '/[^\\]$/q' | tr -d '\\\n')
    command=${command#tidepool}
    # shellcheck disable=SC2086
    "$program" ${command%scene.c} "$scratch/scene.c" &&
        for file in "$scratch/scene.c" tests/boards/readme.c tests/lib/lcd_panel.c \
            ports/lcd/lcd.c ports/lcd/panels.c; do
            cc -std=c11 -O1 -Iinclude -Isrc -Iports -I. -c "$file" \
                -o "$scratch/$(basename "$file" .c).o" || return 1
        done
}

parallel()      # the callbacks for a parallel bus: compiled, not run
{
    {
        echo '#include "lcd/lcd.h"'
        code "### STM32" "*const code"
        echo 'extern const lcd_wires board_wires;'
        echo 'const lcd_wires board_wires = { NULL, command, data, NULL, NULL };'
    } >"$scratch/parallel.c"
    # shellcheck disable=SC2086
    cc $warn -Iinclude -Iports -c "$scratch/parallel.c" -o "$scratch/parallel.o"
}

check "the baked scene, the panel and the driver compile" ready
check "the worked example compiles without a warning" example
for maker in "pico:### Raspberry Pi Pico:static uint dma" "esp:### ESP32-S3:static spi" \
    "stm32:### STM32:static void command"; do
    sdk=${maker%%:*} rest=${maker#*:}
    check "$sdk: the callbacks compile" made "$sdk" "${rest%%:*}" "${rest#*:}"
    check "$sdk: they show the frame" "$scratch/$sdk"
    check "$sdk: a stuck panel is reported" timeout 20 "$scratch/$sdk" stuck
done
"$scratch/pico"
check "the callbacks for a parallel bus compile" parallel

# Figures of the page: two bytes a pixel and 11 bytes a window; test_lcd checks the driver.
figures()
{
    for figure in $((320 * 240 * 2 + 11)) $((320 * 240 * 2 + 11 * 5 * 15)); do
        grep -q "$(echo "$figure" | sed 's/\(...\)$/,\1/')" $page || { echo "$figure"; return 1; }
    done
}
check "the page gives the measured figures" figures

# The driver is freestanding: general registers, memcpy and memset, no memory of its own.
bare()
{
    for file in clear lcd panels turn; do
        cc -std=c11 -Wall -Wextra -Wpedantic -Wconversion -Werror -O2 -ffreestanding -Iinclude \
            -mgeneral-regs-only -fno-pie -c ports/lcd/$file.c -o "$scratch/bare-$file.o" ||
            return 1
    done
    nm -u "$scratch"/bare-*.o | awk 'NF == 2 && $2 !~ \
        /^(mem(cpy|set)|lcd_(begin|tile)|tp_(frame_draw_tile|config_check|format_row_bytes))$/ {
            print; bad = 1 } END { exit bad }' &&
        size "$scratch"/bare-*.o | awk 'NR > 1 && $3 > 0 { print; bad = 1 } END { exit bad }'
}
short() { [ "$(wc -l <ports/lcd/lcd.c)" -le 300 ] && [ "$(wc -l <ports/lcd/panels.c)" -le 300 ]; }
check "the driver is freestanding, and has no memory of its own" bare
check "it is no longer than 300 lines" short

# The model of the panel finds the likely mistakes of a reader.
broken()        # NAME SED: the same callbacks, changed
{
    sed "$2" "$scratch/pico.c" >"$scratch/$1.c"
    cmp -s "$scratch/$1.c" "$scratch/pico.c" && return 0
    cc -std=c11 -Iinclude -Iports -I. "$scratch/$1.c" "$scratch/example.o" \
        "$scratch/scene.o" "$scratch/readme.o" "$scratch/lcd_panel.o" "$scratch/lcd.o" \
        "$scratch/panels.o" build/host/libtidepool.a -o "$scratch/$1" || return 0
    "$scratch/$1"
}
refuse "D/C that moves before the last byte" broken early 's/ || spi_is_busy(spi0)//'
refuse "a D/C that stays low" broken low 's/gpio_put(DC, 1)/gpio_put(DC, 0)/'
refuse "words in place of bytes" broken words 's/DMA_SIZE_8/DMA_SIZE_32/'
finish
