# SPDX-License-Identifier: MIT
# The program and the host library, for machines with files and threads.

# -- files -----------------------------------------------------------------------------

# All files of these folders, except the main files of programs and the preview, which
# needs SDL2.
PORTS_AT := $(addprefix ports/,app/* tools/* interact serial linuxfb null)
PORTS    := $(filter-out %/main.c %/baked_main.c %/reference/reference.c \
                ports/app/preview/%,$(wildcard $(addsuffix /*.c,$(PORTS_AT))))
MAIN     := ports/app/cli/main.c
LIBRARY  := $(wildcard ports/library/*.c)
# Parts for films alone, for tests/cross/film.c.
FILM     := $(addprefix ports/app/files/,atomic_file.c film.c log.c output_file.c path.c \
                picture.c)
# Parts for a screen alone: one static file for a small Linux board.
SCREEN    = $(filter ports/linuxfb/% ports/kms/% ports/app/fullscreen/%,$(PORTS)) \
            ports/app/fullscreen/baked_main.c ports/interact/input_merge.c \
            $(addprefix ports/app/files/,atomic_file.c hashes.c log.c picture.c snapshot.c \
                standard_streams.c timing.c)
# Files that read the library's module list or its parameter table.
LISTED   := src/features/all.c src/features/all_rows.c \
            ports/app/scene/machine.c ports/app/scene/stopwatch.c \
            ports/tools/bake/components.c

# -- libraries found on this machine ---------------------------------------------------

# Screens on Linux, if the kernel's headers are installed.
ifeq ($(shell $(CC) -E ports/kms/mode_select.h >/dev/null 2>&1 && echo yes),yes)
PORTS += $(addprefix ports/kms/, buffer.c card.c connectors.c kms.c mode_select.c)
KMS_CFLAGS := -DTP_HAVE_KMS
endif
ifneq ($(shell pkg-config --exists sdl2 2>/dev/null && echo yes),)
PORTS += $(filter-out %/panel_none.c,$(wildcard ports/app/preview/*.c))
# The panel is C++, with Dear ImGui; the compiler is of the same kind as $(CC).
ifeq ($(origin CXX),default)
CXX := $(if $(findstring clang,$(CC)),$(subst clang,clang++,$(CC)),$(if \
           $(findstring gcc,$(CC)),$(subst gcc,g++,$(CC)),g++))
endif
ifneq ($(shell pkg-config --exists imgui 2>/dev/null && $(CXX) --version 2>/dev/null),)
PORTS += ports/app/preview/panel.cpp
CXX_FLAGS = -std=c++17 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -fno-rtti \
            -fno-exceptions -MMD -MP -fmacro-prefix-map=$(CURDIR)/= $(OPT) $(ARCH) \
            -Iports $(patsubst -I%,-isystem %,$(shell pkg-config --cflags imgui)) \
            $(SDL_CFLAGS) $(CPPFLAGS) $(CXXFLAGS)
PANEL_LIBS := $(shell pkg-config --libs imgui) -Wl,--as-needed -lstdc++ -Wl,--no-as-needed
else
PORTS += ports/app/preview/panel_none.c
endif
PANEL_DEMO = $(BUILD)/tests/host/panel_demo
# SDL's headers include the compiler's vector intrinsics, which nothing here uses; without
# them a file compiles in half the time.
SDL_CFLAGS := $(patsubst -I%,-isystem %,$(shell pkg-config --cflags sdl2)) -DTP_HAVE_SDL2 \
              -DSDL_DISABLE_IMMINTRIN_H
SDL_LIBS   := $(shell pkg-config --libs sdl2)
endif
HOSTED += $(SDL_CFLAGS) $(KMS_CFLAGS)
LIBS   := -lpng -linih -lpthread -lm $(PANEL_LIBS) $(SDL_LIBS)

# -- rules -----------------------------------------------------------------------------

PROGRAM  := $(BUILD)/tidepool
HOST_LIB := $(BUILD)/libtidepool-host.a
objects   = $(patsubst %.cpp,$(BUILD)/%.o,$(patsubst %.c,$(BUILD)/%.o,$1))

$(BUILD)/ports.a: $(call objects,$(PORTS)) $(V3_O)
$(PROGRAM): $(call objects,$(MAIN)) $(BUILD)/ports.a $(LIB)
	$(SAY)$(LINK) $^ $(LIBS) -o $@
# The host library: the parts of the ports that it uses, with only the public names
# visible.
$(HOST_LIB): $(BUILD)/host-library.o
$(BUILD)/host-library.o: $(call objects,$(LIBRARY)) $(BUILD)/ports.a
	$(SAY)$(LD) -r $^ -o $@
	@$(OBJCOPY) --wildcard --keep-global-symbol='tp_host_*' $@
# The program with modules from outside the project: MORE is their folder, and its list.h
# lists them.
MORE_AT  := $(BUILD)/more/$(notdir $(MORE))
MORE_O   := $(patsubst %.c,$(MORE_AT)/%.o,$(LISTED) $(wildcard $(addsuffix /*.c,$(MORE))))
$(MORE_AT)/tidepool: $(call objects,$(MAIN)) $(MORE_O) $(BUILD)/ports.a $(LIB)
	$(SAY)$(LINK) $^ $(LIBS) -o $@
$(MORE_O): $(MORE_AT)/%.o: %.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(SAY)$(COMPILE) $(HOSTED) -UTP_HAVE_PROGRAM_V3 -DTP_MORE='"$(MORE)/list.h"' -c $< -o $@
$(BUILD)/reference: $(BUILD)/ports/tools/reference/reference.o $(BUILD)/ports.a $(LIB)
	$(SAY)$(LINK) $^ $(LIBS) -o $@
$(BUILD)/longship: $(call objects,$(wildcard assets/boats/*.c) assets/textures/canvas.c)
	$(SAY)$(LINK) $^ -lpng -lm -o $@
$(BUILD)/textures: $(call objects,$(wildcard assets/textures/*.c))
	$(SAY)$(LINK) $^ -lpng -o $@
# Builds the host program if it is missing, without the variables for boards and
# compilers.
ifneq ($(PROGRAM),build/host/tidepool)
build/host/tidepool build/host/tests/charts/pool_points:
	@env -i PATH="$$PATH" HOME="$$HOME" $(MAKE) -j2 --no-print-directory $@
endif
