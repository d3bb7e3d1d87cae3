# SPDX-License-Identifier: MIT
# Raspberry Pi 3 in 64 bits (BCM2837, four Cortex-A53), as QEMU's raspi3b emulates it.
TRIPLE  := aarch64-linux-gnu-
ARCH    := -mcpu=cortex-a53 -mgeneral-regs-only -mstrict-align -ffreestanding \
           -fno-pie -no-pie
BOARD_C := $(addprefix ports/rpi/,rpi.c board.c start.c entry.S) $(addprefix ports/, \
           serial/reply.c serial/control.c serial/control_set.c interact/setting.c interact/poke.c \
           interact/old_names.c cortex-m/memory.c)
