# SPDX-License-Identifier: MIT
# Raspberry Pi Pico (RP2040, two Cortex-M0+) with a panel of ports/lcd.
TRIPLE  := arm-none-eabi-
ARCH    := -mcpu=cortex-m0plus -mthumb -mfloat-abi=soft -ffreestanding
include ports/pico/common.mk
BOARD_C := $(addprefix ports/pico/,boot2.S arithmetic.S) $(PICO_C)
# The UF2 format's number of this chip.
UF2_FAMILY := 0xe48bff56
