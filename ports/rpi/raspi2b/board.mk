# SPDX-License-Identifier: MIT
# Raspberry Pi 2 (BCM2836, four Cortex-A7), as QEMU's raspi2b emulates it.
TRIPLE  := arm-none-eabi-
ARCH    := -mcpu=cortex-a7 -marm -mfloat-abi=soft -mno-unaligned-access -ffreestanding
BOARD_C := $(addprefix ports/rpi/,rpi.c board.c start.c entry.S) $(addprefix ports/, \
           serial/reply.c serial/control.c serial/control_set.c interact/setting.c interact/poke.c \
           interact/old_names.c cortex-m/memory.c)
