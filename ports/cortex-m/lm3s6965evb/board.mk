# SPDX-License-Identifier: MIT
# Stellaris LM3S6965 evaluation board (Cortex-M3), as QEMU's lm3s6965evb emulates it.
TRIPLE  := arm-none-eabi-
ARCH    := -mcpu=cortex-m3 -mthumb -mfloat-abi=soft -ffreestanding
BOARD_C := $(addprefix ports/,$(addprefix cortex-m/,lm3s6965evb/main.c lm3s6965evb/evb.c \
               start.c semihost.c memory.c) lcd/lcd.c lcd/ssd0323.c board/answer.c \
               board/control.c board/control_set.c board/buttons.c)
