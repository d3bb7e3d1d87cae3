# SPDX-License-Identifier: MIT
# Netduino Plus 2 (STM32F405, Cortex-M4), as QEMU's netduinoplus2 emulates it.
TRIPLE  := arm-none-eabi-
ARCH    := -mcpu=cortex-m4 -mthumb -mfloat-abi=soft -ffreestanding
BOARD_C := $(addprefix ports/cortex-m/,main.c frame_crc.c start.c \
               semihost.c memory.c)
# An LCD, drawn in bands, in the panel's byte order; --kept streams, because 128 KB of
# RAM cannot hold all grid vertices, and keeps lines of the bands above in 4 KB.
BAKE    := --size 320x240 --format rgb565be --band 4 --kept 4k --no-input
