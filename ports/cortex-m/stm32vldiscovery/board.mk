# SPDX-License-Identifier: MIT
# STM32VLDISCOVERY (STM32F100, Cortex-M3), as QEMU's stm32vldiscovery emulates it.
TRIPLE  := arm-none-eabi-
ARCH    := -mcpu=cortex-m3 -mthumb -mfloat-abi=soft -ffreestanding -DTP_RUN=16
BOARD_C := $(addprefix ports/cortex-m/,main.c frame_crc.c start.c \
               semihost.c memory.c)
# A black and white OLED; fits 8 KB of RAM.
BAKE    := --size 128x64 --format i1 --strip 16 --band 2 --kept 512 --no-input
