# SPDX-License-Identifier: MIT
# Arm MPS2 AN386 (Cortex-M4), as QEMU's mps2-an386 emulates it.
TRIPLE  := arm-none-eabi-
ARCH    := -mcpu=cortex-m4 -mthumb -mfloat-abi=soft -ffreestanding
BOARD_C := $(addprefix ports/cortex-m/,main.c frame_crc.c start.c semihost.c memory.c)
BAKE    := --size 320x240 --format rgb565 --no-input
