# SPDX-License-Identifier: MIT
# BBC micro:bit (nRF51822, Cortex-M0), as QEMU's microbit emulates it.
TRIPLE  := arm-none-eabi-
ARCH    := -mcpu=cortex-m0 -mthumb -mfloat-abi=soft -ffreestanding -DTP_RUN=16
BOARD_C := $(addprefix ports/cortex-m/,microbit/picture.c main.c sum.c start.c \
               semihost.c memory.c)
