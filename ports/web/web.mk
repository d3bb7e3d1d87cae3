# SPDX-License-Identifier: MIT
# The page: the core for WebAssembly by clang alone, and plain files beside it that a
# browser opens from a folder.  Part of the Makefile, which has the names used here.
#
# Code run per pixel or per vertex is compiled for speed (128-bit SIMD, inlined bodies), the
# rest for size: -Dalways_inline= removes that attribute there, to share function bodies.
# wasm-opt, if installed, saves a ninth: data begin at 1024, no pointer is below 1024, and
# wasm-opt may then fold added constants into the offsets of load instructions.

WEB      := build/web
WASM     := build/wasm
CLANG    ?= clang
WASM_LD  ?= wasm-ld
WEB_O    := $(patsubst %.c,$(WASM)/%.o,$(CORE) \
                $(wildcard ports/web/*.c ports/interact/*.c)) $(WASM)/scenes.o
WEB_PAGE := $(patsubst ports/web/%,$(WEB)/%,$(wildcard ports/web/*.html ports/web/*.css) \
                $(filter-out %/serve.js,$(wildcard ports/web/*.js)))
WEB_FAST := $(patsubst %.c,$(WASM)/%.o,$(filter src/shade/% %_stage.c src/raster/% src/pixel/% \
                src/view/% src/fixed/roots.c $(addprefix src/pool/,flux.c subcell.c) \
                $(addprefix src/frame/,grid_water.c scanline_water.c tile.c) \
                %/boat_drawing.c,$(filter-out $(addprefix %/,haze_stage.c tank_stage.c \
                stars_stage.c drops_stage.c underwater_stage.c) $(addprefix src/view/,fan_law.c \
                fan_tank.c fan_filter.c fan_view.c level_plane.c grid.c grid_lines.c grid_vertex.c \
                grid_vertex_terms.c rough.c),$(CORE))))
WEB_FLAGS := --target=wasm32 -std=c11 $(WARN) -MMD -MP -fmacro-prefix-map=$(CURDIR)/= \
             -mbulk-memory -ffreestanding -ffunction-sections -fdata-sections \
             -Iinclude -Isrc -Iports -Iports/web
# Cheaper rungs are for boards: here they are small.  So are haze, glass, stars, drops and the
# water seen from inside, which keep the module below its limit.
WEB_SMALL := $(foreach o,$(WEB_FAST),$(if $(findstring fast,$(notdir $o))$(filter \
                $(addprefix %/,cell.o fan_packed_vertices.o fan_table_vertices.o),$o),$o))
WEB_OPT  := -Oz -Dalways_inline=
$(filter-out $(WEB_SMALL),$(WEB_FAST)): WEB_OPT := -Os -msimd128

page: $(WEB_PAGE) $(WEB)/module.js $(WEB)/files.js

$(WEB_PAGE): $(WEB)/%: ports/web/%
	@mkdir -p $(@D)
	$(SAY)cp $< $@
$(WEB)/files.js: ports/web/pack.sh $(filter assets/boats/% assets/textures/% \
          assets/skies/%,$(SHIPPED))
	@mkdir -p $(@D)
	$(SAY)ports/web/pack.sh files assets >$@.part && mv $@.part $@
$(WEB)/module.js: ports/web/pack.sh $(WASM)/tidepool.wasm
	$(SAY)ports/web/pack.sh module $(WASM)/tidepool.wasm >$@.part && mv $@.part $@

$(WASM)/tidepool.wasm: $(WEB_O)
	$(SAY)$(WASM_LD) --no-entry --gc-sections --strip-all --global-base=1024 $^ -o $@
	@! command -v wasm-opt >/dev/null || \
	    wasm-opt -Oz --low-memory-unused --enable-simd --enable-bulk-memory $@ -o $@
$(WASM)/%.o: %.c $(WASM)/flags ports/web/web.mk
	@mkdir -p $(@D)
	$(SAY)$(CLANG) $(WEB_FLAGS) $(WEB_OPT) -c $< -o $@
$(WASM)/scenes.o: $(WASM)/scenes.c $(WASM)/flags
	$(SAY)$(CLANG) $(WEB_FLAGS) -Oz -c $< -o $@
$(WASM)/scenes.c: ports/web/scenes.awk $(wildcard assets/scenes/*.ini)
	@mkdir -p $(@D)
	$(SAY)awk -f $< $(filter %.ini,$^) >$@
$(WASM)/flags: force
	@mkdir -p $(@D)
	@echo '$(CLANG) $(WEB_FLAGS)' | cmp -s - $@ || echo '$(CLANG) $(WEB_FLAGS)' >$@
.PHONY: web serve page
-include $(shell find $(WASM) -name '*.d' 2>/dev/null)
