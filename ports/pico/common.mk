# SPDX-License-Identifier: MIT
# Files and scene options of both boards.
# CPPFLAGS=-DPICO_PANEL=lcd_st7789 is for another panel of ports/lcd, -DPICO_CORES=1 draws by
# one core.
PICO_C  := $(addprefix ports/,$(addprefix pico/,start.c pico.c panel.c cores.c main.c) \
               $(addprefix cortex-m/,memory.c frame_crc.c live.c) lcd/lcd.c lcd/panels.c \
               $(addprefix serial/,reply.c control.c control_set.c buttons.c) \
               $(addprefix interact/,poke.c setting.c))
# --with links the modules that command lines may switch on.  BAND=8 and KEPT=2k take less
# RAM, for lower tiles and for the water's lines, of which a core then keeps 2 KB, and more
# time; STRIP=128 is the reverse.
# SETTINGS are other options of `tidepool bake`, such as a step that `tidepool plan` prints.
STRIP   ?= 64
BAND    ?= 16
KEPT    ?=
SETTINGS ?=
BAKE    := --size 320x240 --format rgb565be --strip $(STRIP) --band $(BAND) \
           $(if $(KEPT),--kept $(KEPT)) --with lighting,diffuse,reflectance,glint,paddle $(SETTINGS)
# Functions that run in RAM.
IN_RAM  := ports/pico/in_ram.txt
