#!/bin/sh
# SPDX-License-Identifier: MIT
# Baked programs that divide no numbers of 64 bits by the compiler's library, which takes
# about 900 bytes: their few divisions are tp_quotient's.
#
#   tests/boards/division.sh
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/board.sh"

lacks arm-none-eabi-gcc gcc-arm-none-eabi "baked programs" && exit 77

divides()       # ELF: names the functions that call the library's division
{
    arm-none-eabi-objdump -d "$1" | awk '
        /^[0-9a-f]+ <.*>:$/ { within = $2 }
        /<__aeabi_u?ldivmod>$/ { print within; found = 1 }
        END { exit !found }'
}

programs='
cortex-m/netduinoplus2  build/netduinoplus2/scenes/count-64@64.elf
cortex-m/netduinoplus2  build/netduinoplus2/scenes/lava@64.elf
cortex-m/microbit       build/microbit/scenes/bay@64.elf
cortex-m                build/cortex-m/features/0.elf
'
echo "$programs" | sed '/^$/d' >"$scratch/programs"
while read -r board elf; do
    check "$elf builds" build BOARD="$board" "$elf"
    refuse "$elf divides 64 bits by the library" divides "$elf"
done <"$scratch/programs"
user=build/cortex-m/features/2.elf
check "$user builds" build BOARD=cortex-m $user
check "a program whose scene may change does" divides $user
finish
