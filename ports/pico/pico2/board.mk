# SPDX-License-Identifier: MIT
# Raspberry Pi Pico 2 (RP2350, two Cortex-M33): the files of ports/pico without boot stage 2
# and arithmetic, which this processor has.
TRIPLE  := arm-none-eabi-
ARCH    := -mcpu=cortex-m33 -mthumb -mfloat-abi=soft -ffreestanding
include ports/pico/common.mk
BOARD_C := ports/pico/image_def.c $(PICO_C)
UF2_FAMILY := 0xe48bff59
