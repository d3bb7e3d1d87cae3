# SPDX-License-Identifier: MIT
# Arm MPS2 AN505 (Cortex-M33), as QEMU's mps2-an505 emulates it.
TRIPLE  := arm-none-eabi-
ARCH    := -mcpu=cortex-m33 -mthumb -mfloat-abi=soft -ffreestanding
BOARD_C := $(addprefix ports/cortex-m/,main.c frame_crc.c start.c semihost.c memory.c)
BAKE    := --size 320x240 --format rgb565 --no-input
