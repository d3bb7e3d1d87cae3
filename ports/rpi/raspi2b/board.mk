# SPDX-License-Identifier: MIT
# Raspberry Pi 2 (BCM2836, four Cortex-A7), as QEMU's raspi2b emulates it.
TRIPLE  := arm-none-eabi-
ARCH    := -mcpu=cortex-a7 -marm -mfloat-abi=soft -mno-unaligned-access -ffreestanding
BOARD_C := $(addprefix ports/rpi/,rpi.c board.c start.c entry.S) $(addprefix ports/, \
           board/answer.c board/control.c board/control_set.c live/setting.c live/poke.c \
           cortex-m/memory.c)
