# SPDX-License-Identifier: MIT
# Scenes as constants, and the programs of machines without files that draw them: boards,
# emulated processors, and static files for small Linux boards.

SCENES   := $(patsubst assets/scenes/%.ini,%,$(wildcard assets/scenes/*.ini))
# Scenes drawn by tests only.
DRAWN    := $(patsubst tests/golden/scenes/%.ini,%,$(wildcard tests/golden/scenes/*.ini))

# -- bake ------------------------------------------------------------------------------

# Scenes are baked once for each processor, and again when the code that writes them
# changes. SCENE=harbour@32 limits textures to 32 texels a side; SCENE=harbour+cheap and
# harbour+cheap@32 take the rungs of tests/budgets/cheapest.txt, and storm+spray those of that
# line of effects.txt beside it.
BAKES    := $(wildcard ports/tools/bake/*.c ports/app/scene/assets*.c \
                ports/app/scene/scene*.c ports/app/files/*_read.c src/mesh/*.c \
                src/features/all_rows.c include/tidepool/*.h)
SHIPPED  := $(wildcard assets/scenes/*.ini $(addprefix assets/boats/*.,mtl obj png) \
                assets/textures/*.png assets/skies/*.png)
BAKED_FROM := $(BAKES) $(SHIPPED) | build/host/tidepool
define bake
	@mkdir -p $$(@D)
	$$(SAY)build/host/tidepool bake $1 --name baked $2 -o $$@
endef
# Rules for baked scenes in a folder, with options, and with prerequisites besides the
# scene.
define baked_in
$1/%.c: ports/cortex-m/scenes/%.ini $3 $$(BAKED_FROM)
	$(call bake,$$<,$2)
$1/%.c: tests/golden/scenes/%.ini $3 $$(BAKED_FROM)
	$(call bake,$$<,$2)
$1/%+cheap.c: assets/scenes/%.ini tests/budgets/cheapest.txt $3 $$(BAKED_FROM)
	$(call bake,$$<,$2 $$$$(sed -n 's/^$$* //p' tests/budgets/cheapest.txt))
$1/%+cheap.c: tests/budgets/%.ini tests/budgets/cheapest.txt $3 $$(BAKED_FROM)
	$(call bake,$$<,$2 $$$$(sed -n 's/^$$* //p' tests/budgets/cheapest.txt))
$1/%.c: $3 $$(BAKED_FROM)
	$(call bake,assets/scenes/$$(basename $$(@F)).ini,$2)
$1/board-%.c: tests/budgets/board-%.ini $3 $$(BAKED_FROM)
	$(call bake,$$<,$2)
$1/plain-%.c: tests/budgets/plain-%.ini $3 $$(BAKED_FROM)
	$(call bake,$$<,$2)
endef
EFFECTS  := $(shell sed -n 's/^\([a-z0-9-]*+[a-z0-9-]*\) .*/\1/p' tests/budgets/effects.txt)
define baked_effect
$1/$4.c: assets/scenes/$(firstword $(subst +, ,$4)).ini tests/budgets/effects.txt $3 $$(BAKED_FROM)
	$(call bake,$$<,$2 $$$$(sed -n 's/^$4 .*| //p' tests/budgets/effects.txt))
endef
define baked_at
$1/%@$4.c: $5/%.ini $3 $$(BAKED_FROM)
	$(call bake,$$<,$2 --texels $4)
$1/%+cheap@$4.c: $5/%.ini tests/budgets/cheapest.txt $3 $$(BAKED_FROM)
	$(call bake,$$<,$2 --texels $4 $$$$(sed -n 's/^$$* //p' tests/budgets/cheapest.txt))
endef
baked = $(eval $(call baked_in,$1,$2,$3)) $(foreach n,16 32 64 128,$(foreach folder, \
    assets/scenes ports/cortex-m/scenes tests/budgets, \
        $(eval $(call baked_at,$1,$2,$3,$n,$(folder))))) $(foreach effect,$(EFFECTS), \
    $(eval $(call baked_effect,$1,$2,$3,$(effect))))
$(call baked,build/baked)
# A board's baked scenes include the module list for the link, which depends on all
# drawing code and on the options.
ifdef BAKE
$(BUILD)/bake: force
	@mkdir -p $(@D)
	@echo '$(BAKE)' | cmp -s - $@ || echo '$(BAKE)' >$@
$(call baked,$(BUILD)/baked,$(BAKE),build/host/tidepool $(BUILD)/bake)
endif
build/baked/prices.c: tests/budgets/prices.ini $(BAKES) $(SHIPPED) | build/host/tidepool
	@mkdir -p $(@D)
	$(SAY)build/host/tidepool bake $< --name baked -o $@
# For machines with files and for boards that draw by all modules, the compiler gets the
# scene without its texels, and the assembler gets both. LTO needs the whole C file.
build/split/%.c build/split/%.s: build/baked/%.c ports/tools/bake/texels.awk
	@mkdir -p $(@D)
	@awk -v texels=$(@D)/$*.s -f ports/tools/bake/texels.awk $< >$(@D)/$*.c
ifeq ($(filter -flto%,$(OPT)),)
build/baked/$(MACHINE)/%.o: build/split/%.c build/split/%.s
	@mkdir -p $(@D)
	$(SAY)$(COMPILE) -S $< -o $(@:.o=.s)
	@cat build/split/$*.s >>$(@:.o=.s)
	@$(CC) $(ARCH) -c $(@:.o=.s) -o $@ && rm $(@:.o=.s)
else
build/baked/$(MACHINE)/%.o: build/baked/%.c
	@mkdir -p $(@D)
	$(SAY)$(COMPILE) -c $< -o $@
endif
$(BUILD)/baked/%.o: $(BUILD)/baked/%.c $(BUILD)/flags
	$(SAY)$(COMPILE) -c $< -o $@

# -- programs of boards ----------------------------------------------------------------

elf: $(BUILD)/scenes/$(SCENE).elf
elves: $(SCENES:%=$(BUILD)/scenes/%.elf)
BOARD_O  := $(addprefix $(BUILD)/,$(addsuffix .o,$(basename $(BOARD_C))))
ifneq ($(SMALL),)
$(filter-out %/memory.o,$(BOARD_O)): private FLAGS += $(SMALL)
endif
LD_FILES := $(if $(BOARD),$(BOARD_LD) $(wildcard $(addprefix $(dir $(BOARD_LD)), \
               *.ld ../*.ld)))
# A scene's functions that run in RAM, for the linker script of a board with slow flash.
$(BUILD)/in_ram/%/in_ram.ld: $(IN_RAM) ports/pico/in_ram.awk $(BUILD)/bake
	@mkdir -p $(@D)
	@awk -v scene=$* -v settings='$(SETTINGS)' -f ports/pico/in_ram.awk $(IN_RAM) >$@
# All that a test's own program for a board needs besides its own objects.
BOARD_REST := $(filter-out %/main.o,$(BOARD_O)) $(LIB) $(LD_FILES)
LINK_ELF  = $(LINK) -nostdlib $(if $(IN_RAM),-L$(BUILD)/in_ram/$*) -T $(BOARD_LD) \
            -Wl,--gc-sections $(filter %.o,$^) $(LIB) -lgcc -o $@
$(BUILD)/scenes/%.elf: $(if $(BAKE),$(BUILD)/baked,build/baked/$(MACHINE))/%.o \
          $(BOARD_O) $(LIB) $(LD_FILES) $(if $(IN_RAM),$(BUILD)/in_ram/%/in_ram.ld)
	@mkdir -p $(@D)
	$(SAY)$(LINK_ELF) -Wl,-Map=$(@:.elf=.map)
# The content of a board's flash, in whole pages of 256 bytes; and the same in the format
# that the boot ROM of an RP2040 or RP2350 takes.
uf2: $(BUILD)/scenes/$(SCENE).uf2
%.bin: %.elf
	$(SAY)$(OBJCOPY) -O binary $< $@ && truncate -s %256 $@
%.uf2: %.bin ports/pico/uf2.S
	$(SAY)$(CC) $(ARCH) -c -DIMAGE='"$<"' -DBLOCKS=$$(($$(wc -c <$<) / 256)) \
	    -DFAMILY=$(UF2_FAMILY) ports/pico/uf2.S -o $@.o
	@$(OBJCOPY) -O binary -j .uf2 $@.o $@ && rm $@.o
# The program for raw screens.
$(SCENES:%=$(BUILD)/scenes/%-screen): $(BUILD)/scenes/%-screen: $(call objects,$(SCREEN)) \
          build/baked/$(MACHINE)/%.o $(LIB)
	@mkdir -p $(@D)
	$(SAY)$(LINK) -static $^ -lpthread -o $@

list-scenes:
	@echo $(SCENES)
list-bake:
	@echo '$(BAKE)'
.PHONY: elf elves uf2 list-scenes list-bake
