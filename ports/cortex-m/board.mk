# SPDX-License-Identifier: MIT
# Arm MPS2 AN386 (Cortex-M4), as QEMU's mps2-an386 emulates it.
TARGET := cortex-m
CC     := arm-none-eabi-gcc
AR     := arm-none-eabi-ar
ARCH   := -mcpu=cortex-m4 -mthumb -mfloat-abi=soft -ffreestanding
BOARD_C := main.c start.c semihost.c memory.c
