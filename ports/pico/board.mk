# SPDX-License-Identifier: MIT
# Raspberry Pi Pico (RP2040, two Cortex-M0+) with an ILI9341.
# CPPFLAGS=-DPICO_PANEL=lcd_st7789 is for another panel of ports/lcd, -DPICO_CORES=1 draws by
# one core.
TRIPLE  := arm-none-eabi-
ARCH    := -mcpu=cortex-m0plus -mthumb -mfloat-abi=soft -ffreestanding
BOARD_C := $(addprefix ports/,$(addprefix pico/,boot2.S arithmetic.S start.c pico.c \
               panel.c cores.c main.c) cortex-m/memory.c cortex-m/frame_crc.c \
               lcd/lcd.c lcd/panels.c \
               $(addprefix serial/,reply.c control.c control_set.c buttons.c) \
               $(addprefix interact/,poke.c setting.c))
# --with links the modules that command lines may switch on.
BAKE    := --size 320x240 --format rgb565be --strip 64 --band 16 \
           --with lighting,diffuse,reflectance,glint,paddle
