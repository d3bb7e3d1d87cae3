# SPDX-License-Identifier: MIT
# Programs that count instructions and memory, for this machine and for boards.

build/host/count.so build/host/cycles.so: build/host/%.so: tests/budgets/%.c $(BUILD)/flags
	$(SAY)$(COMPILE) -D_POSIX_C_SOURCE=200809L -fPIC -shared $< -o $@
build/host/tally.so: tests/bench/tally.c $(BUILD)/flags
	$(SAY)$(COMPILE) -fPIC -shared $< -o $@

# Costs of models, and prices: errors of the program's own estimates.
MODELS_O := $(patsubst %.c,$(BUILD)/%.o,$(wildcard tests/budgets/models*.c))
# Uses the board's mem*: the C library selects its own at run time by the processor.
$(BUILD)/tests/budgets/models: $(MODELS_O) $(BUILD)/ports/cortex-m/memory.o $(LIB)
	$(SAY)$(LINK) $^ -o $@
$(BUILD)/tests/budgets/slope_colour: $(BUILD)/tests/budgets/slope_colour.o $(BUILD)/ports.a $(LIB)
	$(SAY)$(LINK) $^ $(LIBS) -o $@
$(BUILD)/models.elf: $(MODELS_O) $(BOARD_REST)
	$(SAY)$(LINK_ELF)
$(BUILD)/prices.elf: $(BUILD)/tests/budgets/prices.o build/baked/$(MACHINE)/prices.o \
          $(BOARD_REST)
	$(SAY)$(LINK_ELF)
$(call baked,$(BUILD)/ram,--size 320x240 --format rgb565 --no-input,build/host/tidepool)
$(BUILD)/ram/%.o: $(BUILD)/ram/%.c $(BUILD)/flags
	$(SAY)$(COMPILE) -c $< -o $@
$(BUILD)/ram/%.elf: $(BUILD)/tests/budgets/ram.o $(BUILD)/ram/%.o $(BOARD_REST)
	$(SAY)$(LINK_ELF)

# The minimal program, and programs with the first n features in addition.
FEATURES := tests/budgets/features.txt
PROGRAMS := $(addprefix $(BUILD)/features/,$(shell seq 0 $$(grep -vc '^\#' $(FEATURES))))
programs: $(PROGRAMS:%=%.elf)
$(PROGRAMS:%=%.c): $(BUILD)/features/%.c: tests/budgets/least.ini $(FEATURES) \
          build/host/tidepool
	@mkdir -p $(@D)
	$(SAY)with=$$(grep -v '^#' $(FEATURES) | head -n $* | sed 's/.*| //' | paste -sd, -) && \
	    build/host/tidepool bake $< --size 320x240 --format rgb565 --no-input \
	        $${with:+--with $$with} --name baked -o $@
$(PROGRAMS:%=%.o): %.o: %.c $(BUILD)/flags
	$(SAY)$(COMPILE) -c $< -o $@
$(PROGRAMS:%=%.elf): %.elf: %.o $(BUILD)/tests/budgets/minimal.o $(BOARD_REST)
	$(SAY)$(LINK_ELF) -Wl,-Map=$(@:.elf=.map)
.PHONY: programs
$(BUILD)/tests/budgets/rung_samples: $(BUILD)/tests/budgets/rung_samples.o $(BUILD)/ports.a $(LIB)
	$(SAY)$(LINK) $^ $(LIBS) -o $@

# The shipped scenes in so many KB of RAM: SCENE-KB, with the options of its line.
SHIPPED_RAM := tests/budgets/shipped-ram.txt
$(BUILD)/shipped/baked/%.c: $(SHIPPED_RAM) $(BAKED_FROM)
	@mkdir -p $(@D)
	$(SAY)build/host/tidepool bake --name baked \
	    assets/scenes/$(patsubst %-28,%,$(patsubst %-128,%,$(*:-264=))).ini $(BAKE) \
	    --texels 64 $$(sed -n 's/^$* *| *//p' $(SHIPPED_RAM)) -o $@
$(BUILD)/shipped/baked/%.o: $(BUILD)/shipped/baked/%.c $(BUILD)/flags
	$(SAY)$(COMPILE) -c $< -o $@
$(BUILD)/shipped/%.elf: $(BUILD)/shipped/baked/%.o $(BUILD)/ports/cortex-m/main.o $(BOARD_REST)
	$(SAY)$(LINK_ELF)
# The layout of a frame, here and on a board, for tests/budgets/code-sizes.sh.
$(BUILD)/tests/budgets/layout: $(BUILD)/tests/budgets/layout.o $(LIB)
	$(SAY)$(LINK) $^ -o $@
$(BUILD)/layout.elf: $(BUILD)/tests/budgets/layout.o $(BOARD_REST)
	$(SAY)$(LINK_ELF)
