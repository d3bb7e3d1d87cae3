# SPDX-License-Identifier: MIT
# Raspberry Pi 1 and Zero (BCM2835, one ARM1176), as QEMU's raspi0 emulates it.
TRIPLE  := arm-none-eabi-
ARCH    := -mcpu=arm1176jzf-s -marm -mfloat-abi=soft -mno-unaligned-access -ffreestanding
BOARD_C := $(addprefix ports/rpi/,rpi.c board.c start.c entry.S) $(addprefix ports/, \
           serial/reply.c serial/control.c serial/control_set.c interact/setting.c interact/poke.c \
           interact/old_names.c cortex-m/memory.c)
