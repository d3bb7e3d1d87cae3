# SPDX-License-Identifier: MIT
# Compiler, flags and folders of a build, and the rules for objects and archives. A part
# of the Makefile, as are all files *.mk; those of boards describe a board.

ifdef BOARD
include ports/$(BOARD)/board.mk # TRIPLE, ARCH, BOARD_C; optional BOARD_LD, BAKE
TARGET   := $(notdir $(BOARD))
ARCH     += -fstack-usage -fcallgraph-info=su
CC       := $(TRIPLE)gcc
AR       := $(TRIPLE)ar
OBJCOPY  := $(TRIPLE)objcopy
BOARD_LD ?= ports/$(BOARD)/board.ld
# Boards with the same processor share the core's library; tests build the library first.
CORE_AT  := build/$(patsubst -mcpu=%,%,$(filter -mcpu=%,$(ARCH)))$(if \
              $(filter -DTP_RUN=%,$(ARCH)),-small)
endif
BUILD   := build/$(TARGET)
CORE_AT ?= $(BUILD)

# CFLAGS, CPPFLAGS and LDFLAGS belong to the user.
WARN    := -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wvla -Wdouble-promotion \
           -Wstrict-prototypes -Wmissing-prototypes -Werror
FLAGS   := -std=c11 $(WARN) -Iinclude -MMD -MP -fmacro-prefix-map=$(CURDIR)/= \
           $(OPT) $(ARCH) $(if $(CHECKED),-DTP_CHECKED)
BARE    := -Isrc -ffreestanding -ffunction-sections -fdata-sections
HOSTED  := -Iports -Iports/library -Isrc -I.
COMPILE  = $(CC) $(FLAGS) $(CPPFLAGS) $(CFLAGS)
LINK     = $(CC) $(OPT) $(ARCH) $(LDFLAGS)
ALL_FLAGS = $(COMPILE) $(SMALL) $(TESTS_OPT) $(SDL_CFLAGS)
# Prints one short line for each output; with V=1 the whole command.
SAY      = $(if $(V),,@echo '  $@';)

%.a:
	@rm -f $@
	$(SAY)$(AR) rcs $@ $^
# The core as a shared library for tests: tests/mutants/run.sh links with it. The path is
# absolute, since some tests run a copy of themselves in another folder.
%.so:
	@mkdir -p $(@D)
	$(SAY)$(LINK) -shared -Wl,-soname,$(abspath $@) $^ -o $@
$(BUILD)/%.o: %.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(SAY)$(COMPILE) $(HOSTED) -c $< -o $@
$(BUILD)/%.o: %.cpp $(BUILD)/flags
	@mkdir -p $(@D)
	$(SAY)$(CXX) $(CXX_FLAGS) -c $< -o $@
$(BUILD)/%.o: %.S $(BUILD)/flags
	@mkdir -p $(@D)
	$(SAY)$(COMPILE) -c $< -o $@
# Recompiles everything if the compiler or the flags change.
$(sort $(BUILD)/flags $(CORE_AT)/flags): force
	@mkdir -p $(@D)
	@echo '$(ALL_FLAGS)' | cmp -s - $@ || echo '$(ALL_FLAGS)' >$@

.PHONY: force
.SECONDARY:
-include $(shell find $(sort $(BUILD) $(CORE_AT)) -name '*.d' 2>/dev/null)
