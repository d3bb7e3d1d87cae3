# SPDX-License-Identifier: MIT
# Golden frames and films by programs without files, for each kind of processor.

# Scenes that each processor must draw with equal frames; together they cover all models.
CROSS  := three-swells raindrops tank pond shore-break deep-sea storm count-64 $(DRAWN)
FRAMES := $(CROSS:%=$(BUILD)/tests/cross/frames-%)

$(patsubst %,$(BUILD)/tests/cross/frames-%,$(SCENES) $(DRAWN)): \
          $(BUILD)/tests/cross/frames-%: $(BUILD)/tests/cross/frames.o \
          build/baked/$(MACHINE)/%.o $(LIB)
	$(SAY)$(LINK) $^ -o $@
$(SCENES:%=$(BUILD)/tests/cross/film-%): \
          $(BUILD)/tests/cross/film-%: $(BUILD)/tests/cross/film.o $(call objects,$(FILM)) \
          build/baked/$(MACHINE)/%.o $(LIB)
	$(SAY)$(LINK) $^ -o $@
# The same on a board.
$(SCENES:%=$(BUILD)/tests/cross/frames-%.elf) $(DRAWN:%=$(BUILD)/tests/cross/frames-%.elf): \
          $(BUILD)/tests/cross/frames-%.elf: $(BUILD)/tests/cross/board_frames.o \
          build/baked/$(MACHINE)/%.o $(BOARD_REST)
	$(SAY)$(LINK_ELF)

frames: $(FRAMES)
list-cross:
	@echo $(CROSS)
.PHONY: frames list-cross
