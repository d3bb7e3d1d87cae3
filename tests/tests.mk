# SPDX-License-Identifier: MIT
# Test programs, and the lists of tests that `make test`, `make test-all` and `make soak`
# run.

# -- programs --------------------------------------------------------------------------

UNIT    := $(patsubst %.c,$(BUILD)/%,$(wildcard $(addsuffix /test_*.c,tests/unit \
               tests/host tests/stability tests/accuracy)))
FUZZ    := $(patsubst %.c,$(BUILD)/%,$(wildcard tests/fuzz/fuzz_*.c))
GOLDEN  := $(BUILD)/tests/golden/test_frames $(BUILD)/tests/golden/test_harness
LISTS   := $(BUILD)/tests/unit/test_world_params_list $(BUILD)/tests/unit/test_quality_fixed_cost
CMOCKA  := -lcmocka
# Tests left out because a library is missing: LEFT_OUT lists them as TEST=PACKAGE, and
# tests/gates/left-out.sh reports them.
LEFT_OUT :=
without = $(eval LEFT_OUT += $(patsubst $(BUILD)/%,%=$1,$(filter $2,$(UNIT) $(GOLDEN)))) \
          $(eval UNIT := $(filter-out $2,$(UNIT))) \
          $(eval GOLDEN := $(filter-out $2,$(GOLDEN)))
ifneq ($(shell pkg-config --exists cmocka 2>/dev/null && echo yes),yes)
CMOCKA  :=
$(call without,libcmocka-dev,%)
endif
ifndef KMS_CFLAGS
$(call without,libdrm-dev,%/test_kms %/test_kms_mode_select)
endif
ifndef SDL_CFLAGS
$(call without,libsdl2-dev,$(addprefix %/test_,keymap font overlay gamepad window \
    panel_keys panel_rows))
FUZZ    := $(filter-out %/fuzz_keys,$(FUZZ))
endif
ifeq ($(filter %/panel.cpp,$(PORTS)),)
$(call without,$(if $(shell pkg-config --exists imgui 2>/dev/null && echo yes),g++,$(strip \
    libimgui-dev)),%/test_panel_keys %/test_panel_rows)
endif

# The faster linker, if installed: tests are hundreds of programs.
GOLD    := $(if $(shell command -v ld.gold),-fuse-ld=gold)
# These tests' own objects need no speed, since the library does the work.
$(BUILD)/tests/unit/%.o $(BUILD)/tests/host/%.o: private FLAGS += $(TESTS_OPT)

$(UNIT): $(UNIT_LIB)
$(BUILD)/tests/%: $(BUILD)/tests/%.o $(BUILD)/ports.a $(LIB)
	$(SAY)$(LINK) $(GOLD) $(filter %.o,$^) $(BUILD)/ports.a \
	    $(or $(filter $(UNIT_LIB),$^),$(LIB)) $(CMOCKA) $(LIBS) -o $@
$(filter $(BUILD)/%,$(GOLDEN)): $(BUILD)/tests/lib/golden.o
$(BUILD)/tests/host/test_kms: $(BUILD)/tests/host/fake_kms.o
$(BUILD)/tests/host/apng_frames: LIBS += -lz
$(BUILD)/screen_fake.so $(BUILD)/faults.so: $(BUILD)/%.so: tests/host/%.c $(BUILD)/flags
	$(SAY)$(COMPILE) -fPIC -shared $< -ldl -o $@
# Fuzz targets: all readers of bytes, in the core and the ports.
$(FUZZ): $(BUILD)/%: $(BUILD)/%.o $(BUILD)/ports.a $(LIB)
	$(SAY)$(LINK) -fsanitize=fuzzer -Wl,--as-needed $(filter %.o,$^) $(BUILD)/ports.a \
	    $(LIB) $(LIBS) -o $@
# The same targets without libFuzzer, of any compiler.
REPLAY  := $(FUZZ:$(BUILD)/tests/fuzz/fuzz_%=$(BUILD)/tests/fuzz/replay_%)
$(REPLAY): $(BUILD)/tests/fuzz/replay_%: $(BUILD)/tests/fuzz/fuzz_%.o \
          $(BUILD)/tests/fuzz/replay.o $(BUILD)/ports.a $(LIB)
	$(SAY)$(LINK) $(GOLD) -Wl,--as-needed $(filter %.o,$^) $(BUILD)/ports.a $(LIB) $(LIBS) \
	    -o $@
# Other renderers for `tidepool bench --peers`, as far as their packages are installed.
PEERS   := $(BUILD)/tests/bench/peers
peers:
	@for peer in osmesa=osmesa:libosmesa6-dev sdl=sdl2:libsdl2-dev; do \
	    name=$${peer%=*} package=$${peer#*=}; \
	    if pkg-config --exists $${package%:*} 2>/dev/null; then \
	        $(MAKE) --no-print-directory $(PEERS)/$$name || exit 1; \
	    else \
	        echo "left out: $$name (package $${package#*:}; ports/setup.sh bench)"; \
	    fi; \
	done
$(PEERS)/osmesa: LIBS += -lOSMesa
$(PEERS)/%: $(PEERS)/%.o $(PEERS)/peer.o $(BUILD)/ports.a $(LIB)
	$(SAY)$(LINK) $^ $(LIBS) -o $@

# -- make test -------------------------------------------------------------------------

# The quick tests run without sanitizers, the library's asserts on; here are those that
# take longer, which `make test-all` runs.
LONG    := $(BUILD)/tests/stability/% $(BUILD)/tests/accuracy/% $(addprefix %/test_, \
               features_water_quick_light features_water_quick_even frame_hostile \
               frame_tiles quality_plan quality_fixed_cost world \
               app_overlay snapshot rows threads undo)
QUICK   := $(filter-out $(LONG),$(UNIT))
RUN     := TP_BUILD=$(BUILD) TP_PROGRAM=$(PROGRAM) TP_LEFT_OUT='$(LEFT_OUT)' tests/run.sh

unit: $(UNIT)
quick: all $(QUICK) $(GOLDEN) $(BUILD)/faults.so $(BUILD)/screen_fake.so
quick-tests: quick
	@$(RUN) build/log/host tests/host/cli.sh $(QUICK) $(GOLDEN) \
	    $(if $(LEFT_OUT),tests/gates/left-out.sh) \
	    $(patsubst %,tests/gates/%.sh,sources headers glossary words selftest) \
	    $(patsubst %,tests/host/%.sh,manual exits check_ranges linked readme) \
	    $(patsubst %,tests/boards/%.sh,readme figures) tests/mutants/selftest.sh

# -- make test-all ---------------------------------------------------------------------

# Tests run under the sanitizers, except: those of errors, of stability and others that take
# longest, most of them for comparing the bits of tilings and of two bodies, are sanitized in
# the soak only; threads have a test of their own. The second copy
# of the pixel loops is compiled with light optimisation, and sanitized only where its
# source differs from the first copy.
SAN     := TARGET=san OPT='-O1 -g1 -fsanitize=address,undefined -fno-sanitize-recover=all' \
           V3_OPT='-O1 -march=x86-64-v3' V3_SAME_OPT=-fno-sanitize=all \
           TESTS_OPT=-O0 CHECKED=1
SAN_SOAK := $(filter $(addprefix $(BUILD)/tests/,accuracy/% stability/% \
               $(addprefix unit/test_,fixed% pool% quality% shade% view% waves%)) \
               $(addprefix %/test_, app_overlay compare component_search \
               features_drops_drawing features_statements features_tank \
               features_water_quick_even features_water_quick_layers \
               features_water_quick_light frame_fan frame_fan_detail \
               frame_fan_kept frame_fast_rows frame_history frame_mirror frame_samples \
               frame_scanline_grid frame_screen_grid frame_small lcd_paper mesh_found \
               raster_cell rows stopwatch \
               undo world_water_sample_pick),$(UNIT))
SAN_UNIT := $(filter-out $(SAN_SOAK) %/test_threads,$(UNIT))
sanitized: $(SAN_UNIT) $(GOLDEN) $(PROGRAM) $(PANEL_DEMO) $(REPLAY)
at_san   = $(patsubst $(BUILD)/%,build/san/%,$1)

everything: quick $(PANEL_DEMO) $(filter-out $(SAN_UNIT),$(UNIT)) $(FRAMES) \
          $(BUILD)/longship $(BUILD)/textures \
          $(addprefix $(BUILD)/tests/,bench/scene_s bench/views boards/oled_greys \
              boards/same_picture boards/vm_state host/apng_frames host/furniture \
              host/same_pixels host/saves host/screen_crc)
# Tests of accuracy that take longest; those of SOAKED run in the soak only.
SLOW    := $(filter $(addprefix %/accuracy/test_,engine foam_rings plan),$(UNIT))
SOAKED  := $(filter $(addprefix %/accuracy/test_,engine_foam foam_map glitter \
               reference_caustics reference_depths),$(UNIT))
# Builds first what several tests need from the board's compiler; the longest tests begin
# first.
more-tests: everything build/host/count.so build/host/tally.so
	@$(MAKE) --no-print-directory $(SAN) sanitized
	@! command -v arm-none-eabi-gcc >/dev/null || \
	    for goals in 'BOARD=cortex-m elves' 'BOARD=cortex-m/microbit lib' \
	            'BOARD=cortex-m/lm3s6965evb lib' \
	            'BOARD=cortex-m/m0plus lib' charts-tools; do \
	        $(MAKE) --no-print-directory $$goals || exit 1; \
	    done
	@$(RUN) build/log/more tests/cross/run.sh tests/charts/sweep.sh tests/fuzz/replay.sh \
	    tests/boards/cortex-m.sh $(SLOW) \
	    $(patsubst %,tests/gates/%.sh,arm clang wide) \
	    $(patsubst %,tests/host/%.sh,screen view panel view_keys leaks) \
	    tests/web/web.sh tests/bench/views.sh tests/cross/film.sh tests/accuracy/errors.sh \
	    tests/accuracy/rungs.sh \
	    $(patsubst %,tests/boards/%.sh,rpi oled control pico linuxfb kms new_board division) \
	    tests/budgets/prices.sh \
	    $(call at_san,$(filter $(LONG),$(SAN_UNIT)) $(filter-out $(LONG),$(SAN_UNIT))) \
	    $(filter-out $(SAN_UNIT) $(SLOW) $(SOAKED) $(QUICK),$(UNIT)) $(call at_san,$(GOLDEN)) \
	    $(patsubst %,tests/host/%.sh,check packages output bake own_module library tape ladder \
	        charts generators examples charts_stop) \
	    $(patsubst %,tests/budgets/%.sh,models-count scenes-count ram shipped-ram programs \
                plan-count effects rung-prices rung-judge board-rungs processor-prices board-steps \
                code-sizes program-memory) \
	    tests/charts/same.sh
# Tests that have fewer rounds under the sanitizers than in the soak.
MORE_ROUNDS := $(filter $(addprefix %/test_, world app_overlay lcd rows snapshot \
               frame_history frame_hostile frame_project frame_screen_grid frame_stream \
               frame_tiles interact_setting mesh_triangulate_large quality_fixed_cost \
               quality_plan raster_attributes raster_fill undo), $(UNIT))
# The random scenes, tapes and builds that a whole run has fewer of; all other processors,
# raspi0 and raspi3b; boards at -O2; the console; host's object code (tests/gates/arm.sh has
# the same gates for boards); and more numbers of threads.
SOAK    := TP_SOAK=1 TP_SCENES=10000 FUZZ_SECONDS=$${FUZZ_SECONDS:-300} TP_TIMEOUT=7200
soak-tests: everything build/host/count.so build/host/tally.so
	@$(MAKE) --no-print-directory $(SAN) unit sanitized
	@$(SOAK) $(RUN) build/log/soak \
	    $(patsubst %,tests/gates/%.sh,coverage sanitized host) \
	    tests/cross/run.sh tests/fuzz/run.sh tests/bench/views.sh tests/accuracy/rungs.sh \
	    tests/charts/sweep.sh \
	    $(patsubst %,tests/boards/%.sh,rpi linuxfb kms_events console pico_scenes) \
	    $(patsubst %,tests/budgets/%.sh,prices models-count scenes-count \
                effects rung-judge board-rungs code-sizes \
                processor-prices) \
	    $(patsubst %,tests/host/%.sh,threads saves generators ladder \
                furniture); scripts=$$?; \
	$(SOAK) TP_BUILD=build/san tests/run.sh build/log/soak-sanitized \
	    $(call at_san,$(sort $(SAN_SOAK) $(MORE_ROUNDS))) && exit $$scripts
fuzzers: $(FUZZ)
list-tests:
	@for test in $(patsubst $(BUILD)/%,%,$(UNIT) $(GOLDEN)) $(LEFT_OUT); do \
	    echo $$test; \
	done
.PHONY: unit quick quick-tests sanitized everything more-tests soak-tests fuzzers peers \
    list-tests
