# SPDX-License-Identifier: MIT
# The core: its library, a copy with asserts, and a second copy of the pixel loops.

CORE     := $(sort $(wildcard src/*/*.c src/*/*/*.c))
CORE_O   := $(CORE:%.c=$(CORE_AT)/%.o)
LIB      := $(CORE_AT)/libtidepool.a
# Asserts (src/base/base.h) are off in a release and on with CHECKED=1. Unit tests link
# a library with asserts.
ASSERT_O := $(BUILD)/tests/lib/assert_failed.o
UNIT_LIB := $(if $(CHECKED),$(LIB),$(BUILD)/checked/libtidepool.a)

# On x86-64 the pixel loops are compiled a second time, for processors of level v3:
# tp_program_v3, whose other names are hidden. The tuning makes compilers use gathers.
# V3_C= turns the second copy off.
V3_FOLDERS := pixel view raster shade frame
ifeq ($(firstword $(subst -, ,$(shell $(CC) -dumpmachine 2>/dev/null))),x86_64)
V3_C     := $(filter $(foreach f,$(V3_FOLDERS),src/$f/%) src/features/all.c %_drawing.c \
               %_stage.c,$(CORE))
V3_OPT   := -O3 -march=x86-64-v3 -mtune=skylake
# Files with the same source for both copies: files without loops for vector units.
ifdef V3_SAME_OPT
V3_SAME  := $(filter-out $(shell grep -lE 'TP_WIDE|slope\.h"|_plain\.h"' $(V3_C)),$(V3_C))
endif
HOSTED   += $(if $(V3_C),-DTP_HAVE_PROGRAM_V3)
endif
V3_O     := $(if $(V3_C),$(BUILD)/program_v3.o)

# For boards, files of little work are compiled for size: all that hot.txt does not name.
HOT      := $(wildcard $(addprefix src/,$(shell grep '^[a-z*]' src/hot.txt)))
SMALL    := $(if $(BOARD),$(patsubst -O2,-Os,$(filter -O2,$(OPT))))
ifneq ($(SMALL),)
$(patsubst %.c,$(CORE_AT)/%.o,$(filter-out $(HOT),$(CORE))): private FLAGS += $(SMALL)
endif

$(LIB): $(CORE_O) $(if $(CHECKED),$(ASSERT_O))
$(BUILD)/checked/libtidepool.a: $(CORE:%.c=$(BUILD)/checked/%.o) $(ASSERT_O)
$(BUILD)/program_v3.o: $(V3_C:%.c=$(BUILD)/v3/%.o)
	$(SAY)$(LD) -r $^ -o $@
	@$(OBJCOPY) --keep-global-symbol=tp_program_v3 $@
$(CORE_AT)/src/%.o: src/%.c $(CORE_AT)/flags $(if $(SMALL),src/hot.txt)
	@mkdir -p $(@D)
	$(SAY)$(COMPILE) $(BARE) -c $< -o $@
$(BUILD)/checked/src/%.o: src/%.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(SAY)$(COMPILE) $(BARE) -DTP_CHECKED -c $< -o $@
$(BUILD)/v3/src/%.o: src/%.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(SAY)$(COMPILE) $(BARE) $(V3_OPT) -Dtp_program_all=tp_program_v3 \
	    $(if $(filter $<,$(V3_SAME)),$(V3_SAME_OPT)) -c $< -o $@

list-core:
	@echo $(CORE)
.PHONY: list-core
