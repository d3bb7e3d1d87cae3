# SPDX-License-Identifier: MIT
# The memory of ports/cortex-m with code for a Cortex-M0+: QEMU's mps2-an386 runs it too,
# since a Cortex-M4 has all instructions of a Cortex-M0+.
TRIPLE   := arm-none-eabi-
ARCH     := -mcpu=cortex-m0plus -mthumb -mfloat-abi=soft -ffreestanding
BOARD_C  := $(addprefix ports/cortex-m/,main.c frame_crc.c start.c semihost.c memory.c)
BOARD_LD := ports/cortex-m/board.ld
BAKE     := --size 320x240 --format rgb565 --no-input
