# SPDX-License-Identifier: MIT
# Programs for the tests of boards.

LCD_O   := $(patsubst %,$(BUILD)/%.o,$(addprefix ports/lcd/,clear lcd panels ssd0323 turn) \
               tests/lib/lcd_panel tests/lib/golden)
$(filter $(BUILD)/tests/host/test_lcd%,$(UNIT)): $(LCD_O)
$(BUILD)/tests/boards/sent: $(filter %/clear.o %/lcd.o %/panels.o %/turn.o,$(LCD_O))
$(BUILD)/tests/boards/vm_state: $(BUILD)/tests/boards/vm_state.o
	$(SAY)$(LINK) -static $^ -o $@

# A Pico with the other panel.
$(BUILD)/st7789/main.o: ports/pico/main.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(SAY)$(COMPILE) $(SMALL) $(HOSTED) -DPICO_PANEL=lcd_st7789 -c $< -o $@
$(BUILD)/st7789/%.elf: $(BUILD)/st7789/main.o $(BUILD)/baked/%.o $(BOARD_REST) \
          $(BUILD)/in_ram/%/in_ram.ld
	$(SAY)$(LINK_ELF)

# A Pico 2's scene and library for two emulated processors of the same kind.
TWO_CORES := $(addprefix $(BUILD)/,tests/boards/two_cores.o $(addprefix ports/cortex-m/, \
               frame_crc.o start.o semihost.o memory.o))
$(BUILD)/two_cores/%.elf: private BOARD_LD := ports/cortex-m/mps2-an505/board.ld
$(BUILD)/two_cores/%.elf: $(TWO_CORES) $(BUILD)/baked/%.o $(LIB)
	@mkdir -p $(@D)
	$(SAY)$(LINK_ELF)

# A board whose program fails, each in another way.
FAULTS  := $(addprefix $(BUILD)/faults/,address instruction stack ram)
$(FAULTS:%=%.o): $(BUILD)/faults/%.o: tests/boards/faults.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(SAY)$(COMPILE) $(HOSTED) -DFAULT_$* -c $< -o $@
$(FAULTS:%=%.elf): $(BUILD)/faults/%.elf: $(BUILD)/faults/%.o \
          $(filter-out %/frame_crc.o,$(BOARD_REST))
	$(SAY)$(LINK_ELF)
