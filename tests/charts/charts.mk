# SPDX-License-Identifier: MIT
# Measuring programs of `tidepool charts`, for this machine and for an emulated board.
# A part of the Makefile, which defines the names used here.

AT := $(BUILD)/tests/charts

KERNELS_O   := $(patsubst %.c,$(BUILD)/%.o,$(wildcard tests/charts/kernels*.c)) \
               $(AT)/kernel_lists.o
STABILITY_O := $(patsubst %.c,$(BUILD)/%.o,$(wildcard tests/charts/stability_*.c)) \
               $(AT)/used.o
POOLS_O     := $(addprefix $(AT)/,pool_feed.o pool_rules.o pool_runs.o pool_sponge.o \
                   pool_truth.o pool_walls.o pool_waves.o)
SPAN_SCENES := from-above three-swells
SPAN_STEPS  := 0 1 8 16 32
SPAN_O      := $(addprefix $(AT)/,span_scene.o span_steps.o span_true.o \
                   $(SPAN_STEPS:%=span_step_%.o))
CHARTS      := $(addprefix $(AT)/,errors frames kernels ladder pool_count \
                   pool_edges_count pools reference regret \
                   rough_fresnel stability visibility wave_cells $(SPAN_SCENES:%=span-%) \
                   $(SPAN_SCENES:%=span_errors-%) $(SCENES:%=board-%))
CHARTS_ELF  := $(patsubst %,build/cortex-m/%.elf,kernels pool_count pool_edges_count \
                   $(SPAN_SCENES:%=span-%) $(SCENES:%=charts/%))

charts-tools: all build/host/count.so $(CHARTS) $(BUILD)/tests/budgets/rung_samples
	@$(MAKE) --no-print-directory BOARD=cortex-m $(CHARTS_ELF)
# The pictures of the shipped scenes, or of SCENE, for a Cortex-M4 and a Cortex-M0+.
processor-tools: $(PROGRAM) build/host/count.so build/host/cycles.so
	@for board in cortex-m cortex-m/m0plus; do \
	    $(MAKE) --no-print-directory BOARD=$$board \
	        $(patsubst %,build/$${board##*/}/charts/%.elf,$(or $(ONE),$(SCENES))) || exit 1; \
	done

# A scene with the rungs of a board's step, which tests/budgets/board-steps.sh writes as
# options of `tidepool bake`.
build/baked/rp2040-%.c: build/steps/rp2040-%.txt $(BAKED_FROM)
	@mkdir -p $(@D)
	$(SAY)build/host/tidepool bake assets/scenes/$*.ini --name baked $$(cat $<) -o $@

# -- for this machine --------------------------------------------------------------------

$(AT)/kernels: $(KERNELS_O) $(LIB)
	$(SAY)$(LINK) $^ -lm -o $@
$(SCENES:%=$(AT)/board-%): \
          $(AT)/board-%: $(AT)/board.o \
          build/baked/$(MACHINE)/%.o $(BUILD)/ports/cortex-m/memory.o $(LIB)
	$(SAY)$(LINK) -no-pie $^ -o $@
$(AT)/errors: $(patsubst %.c,$(BUILD)/%.o,$(wildcard tests/charts/errors*.c)) \
          $(filter-out %/kernels.o,$(KERNELS_O)) \
          $(AT)/used.o $(BUILD)/ports.a $(LIB)
	$(SAY)$(LINK) $^ $(LIBS) -o $@
$(AT)/ladder: $(AT)/ladder.o $(BUILD)/ports.a $(LIB)
	$(SAY)$(LINK) $^ $(LIBS) -o $@
$(AT)/regret: $(AT)/regret.o $(AT)/regret_search.o $(BUILD)/ports.a $(LIB)
	$(SAY)$(LINK) $^ $(LIBS) -o $@
$(AT)/rough_fresnel $(AT)/wave_cells: $(AT)/%: $(AT)/%.o $(LIB)
	$(SAY)$(LINK) $^ -lm -o $@
# Spans of triangles with other steps, instead of the library's.  In affine spans, which are
# inlined further, compilers do not see that an unset edge is never walked.
$(SPAN_STEPS:%=$(AT)/span_step_%.o): \
          $(AT)/span_step_%.o: src/raster/span.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(SAY)$(COMPILE) $(BARE) -DTP_SPAN_STEP=$* $(foreach f,tri_water cell_water tri_solid \
	    tri_solid_wide tri_depth_only gbuffer_clear,-Dtp_$f=tp_$f_$*) \
	    $(if $(*:0=),,-Wno-unknown-warning-option -Wno-maybe-uninitialized) \
	    -c $< -o $@
$(SPAN_SCENES:%=$(AT)/span-%): $(AT)/span-%: \
          $(AT)/span.o $(SPAN_O) build/baked/$(MACHINE)/%.o \
          $(BUILD)/ports/cortex-m/memory.o $(LIB)
	$(SAY)$(LINK) $^ -lm -o $@
$(SPAN_SCENES:%=$(AT)/span_errors-%): $(AT)/span_errors-%: \
          $(AT)/span_errors.o $(SPAN_O) build/baked/$(MACHINE)/%.o \
          $(AT)/span_used.o $(BUILD)/ports.a $(LIB)
	$(SAY)$(LINK) $^ $(LIBS) -o $@
$(AT)/stability: $(AT)/stability.o $(STABILITY_O) \
          $(BUILD)/ports.a $(LIB)
	$(SAY)$(LINK) $^ $(LIBS) -o $@
# Bakes the scenes: boards cannot read files.
build/baked/pool_points.c: tests/charts/pool_points.c $(BAKES) $(SHIPPED) \
          | build/host/tests/charts/pool_points
	@mkdir -p $(@D)
	$(SAY)build/host/tests/charts/pool_points >$@
build/baked/$(MACHINE)/pool_points.o: FLAGS += -I.
$(AT)/pool_count: $(AT)/pool_count.o \
          build/baked/$(MACHINE)/pool_points.o $(BUILD)/ports/cortex-m/memory.o $(LIB)
	$(SAY)$(LINK) $^ -o $@
$(AT)/pool_edges_count: $(AT)/pool_edges_count.o \
          $(BUILD)/ports/cortex-m/memory.o $(LIB)
	$(SAY)$(LINK) $^ -o $@
$(AT)/pools: $(POOLS_O) $(AT)/used.o \
          build/baked/$(MACHINE)/pool_points.o

# -- for the board ---------------------------------------------------------------------

$(SPAN_SCENES:%=$(BUILD)/span-%.elf): $(BUILD)/span-%.elf: \
          $(AT)/span.o $(SPAN_O) build/baked/$(MACHINE)/%.o \
          $(filter-out %/main.o,$(BOARD_O)) $(LIB) $(BOARD_LD)
	$(SAY)$(LINK_ELF)
$(BUILD)/kernels.elf: $(KERNELS_O) \
          $(filter-out %/main.o,$(BOARD_O)) $(LIB) $(BOARD_LD)
	$(SAY)$(LINK_ELF)
$(BUILD)/charts/%.elf: $(AT)/board.o build/baked/$(MACHINE)/%.o \
          $(filter-out %/main.o,$(BOARD_O)) $(LIB) $(BOARD_LD)
	@mkdir -p $(@D)
	$(SAY)$(LINK_ELF)
$(BUILD)/pool_count.elf: $(AT)/pool_count.o \
          build/baked/$(MACHINE)/pool_points.o \
          $(filter-out %/main.o,$(BOARD_O)) $(LIB) $(BOARD_LD)
	$(SAY)$(LINK_ELF)
$(BUILD)/pool_edges_count.elf: $(AT)/pool_edges_count.o \
          $(filter-out %/main.o,$(BOARD_O)) $(LIB) $(BOARD_LD)
	$(SAY)$(LINK_ELF)

# -- tests -----------------------------------------------------------------------------

$(filter %/test_maps,$(UNIT)): $(STABILITY_O)
$(filter %/test_chart_truths,$(UNIT)): $(filter-out %/span_scene.o,$(SPAN_O))
$(filter %/test_pool_truth %/test_pool_maps %/test_pool_noise,$(UNIT)): $(POOLS_O) $(AT)/used.o
