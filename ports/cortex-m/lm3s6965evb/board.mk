# SPDX-License-Identifier: MIT
# Stellaris LM3S6965 evaluation board (Cortex-M3), as QEMU's lm3s6965evb emulates it.
TRIPLE  := arm-none-eabi-
ARCH    := -mcpu=cortex-m3 -mthumb -mfloat-abi=soft -ffreestanding
BOARD_C := $(addprefix ports/,$(addprefix cortex-m/,lm3s6965evb/main.c lm3s6965evb/evb.c \
               start.c semihost.c memory.c live.c) $(addprefix lcd/,lcd.c panels.c ssd0323.c) \
               $(addprefix serial/,reply.c control.c control_set.c buttons.c) \
               $(addprefix interact/,poke.c setting.c))
# An OLED, drawn in bands; 64 KB of RAM cannot hold all grid vertices.  --with links the
# modules that command lines may switch on, except features that need a file or memory that
# was not reserved: commands for them are refused.
BAKE    := --size 128x64 --format l8 --band 8 --kept 2k \
           --with lighting,diffuse,reflectance,glint,paddle
