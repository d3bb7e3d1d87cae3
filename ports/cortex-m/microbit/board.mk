# SPDX-License-Identifier: MIT
# BBC micro:bit (nRF51822, Cortex-M0), as QEMU's microbit emulates it.
TRIPLE  := arm-none-eabi-
ARCH    := -mcpu=cortex-m0 -mthumb -mfloat-abi=soft -ffreestanding -DTP_RUN=16
BOARD_C := $(addprefix ports/cortex-m/,main.c frame_crc.c start.c \
               semihost.c memory.c)
# A small colour LCD; fits 16 KB of RAM.
BAKE    := --size 160x128 --format rgb565be --strip 16 --band 4 --no-input
