# SPDX-License-Identifier: MIT
# Netduino Plus 2 (STM32F405, Cortex-M4), as QEMU's netduinoplus2 emulates it.
TRIPLE  := arm-none-eabi-
ARCH    := -mcpu=cortex-m4 -mthumb -mfloat-abi=soft -ffreestanding
BOARD_C := $(addprefix ports/cortex-m/,netduinoplus2/picture.c main.c sum.c start.c \
               semihost.c memory.c)
