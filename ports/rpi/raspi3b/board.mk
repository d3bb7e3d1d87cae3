# SPDX-License-Identifier: MIT
# Raspberry Pi 3 in 64 bits (BCM2837, four Cortex-A53), as QEMU's raspi3b emulates it.
TRIPLE  := aarch64-linux-gnu-
ARCH    := -mcpu=cortex-a53 -mgeneral-regs-only -mstrict-align -ffreestanding \
           -fno-pie -no-pie
BOARD_C := $(addprefix ports/rpi/,rpi.c board.c start.c entry.S) $(addprefix ports/, \
           board/answer.c board/control.c board/control_set.c live/setting.c live/poke.c \
           cortex-m/memory.c)
