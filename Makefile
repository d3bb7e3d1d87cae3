# SPDX-License-Identifier: MIT
# Tidepool. `make help` lists the targets. Output goes to build/TARGET/, so builds of
# several kinds can coexist:
#   make TARGET=clang CC=clang
# A board is a target, described in its folder; board builds also write stack sizes, for
# tests/gates/arm.sh:
#   make BOARD=cortex-m elf

MAKEFLAGS += --no-builtin-rules
TARGET  ?= host
MACHINE ?= $(TARGET)
# Only line numbers for debuggers: optimised code has little more; or OPT='-Og -g'
OPT     ?= -O2 -g1
ARCH    ?=
PREFIX  ?= /usr/local
SCENE   ?= three-swells
OBJCOPY ?= objcopy
all:
ifdef BOARD
include ports/$(BOARD)/board.mk # TRIPLE, ARCH, BOARD_C; optional BOARD_LD, BAKE
TARGET   := $(notdir $(BOARD))
ARCH     += -fstack-usage -fcallgraph-info=su
CC       := $(TRIPLE)gcc
AR       := $(TRIPLE)ar
OBJCOPY  := $(TRIPLE)objcopy
BOARD_LD ?= ports/$(BOARD)/board.ld
LD_FILES := $(BOARD_LD) $(wildcard $(dir $(BOARD_LD))../*.ld)
# Boards with the same processor share the core's library; tests build the library first.
CORE_AT  := build/$(patsubst -mcpu=%,%,$(filter -mcpu=%,$(ARCH)))$(if \
              $(filter -DTP_RUN=%,$(ARCH)),-small)
endif
BUILD   := build/$(TARGET)
CORE_AT ?= $(BUILD)

# -- the core, by rank -----------------------------------------------------------------

CORE := $(sort $(wildcard src/*/*.c src/features/*/*.c))

# -- the tools, for machines with files and threads ------------------------------------

# All files of these folders except the programs' main files; the tests' reference
# renderer is included, for the preview's comparison.
PORTS := $(filter-out %/main.c %/baked_main.c %/reference/reference.c,$(wildcard $(addsuffix /*.c,\
             ports/app/cli ports/app/files ports/app/scene ports/app/session ports/app/fullscreen ports/interact \
             ports/linuxfb ports/null ports/serial ports/tools/*)))
MAIN  := ports/app/cli/main.c
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
SDL_CFLAGS := $(patsubst -I%,-isystem %,$(shell pkg-config --cflags sdl2)) -DTP_HAVE_SDL2
SDL_LIBS   := $(shell pkg-config --libs sdl2)
endif
LIBS := -lpng -linih -lpthread -lm $(PANEL_LIBS) $(SDL_LIBS)

# -- compiler flags; CFLAGS and LDFLAGS belong to the user -----------------------------

WARN   := -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wvla -Wdouble-promotion \
          -Wstrict-prototypes -Wmissing-prototypes -Werror
FLAGS  := -std=c11 $(WARN) -Iinclude -MMD -MP -fmacro-prefix-map=$(CURDIR)/= \
          $(OPT) $(ARCH) $(if $(CHECKED),-DTP_CHECKED)
BARE   := -Isrc -ffreestanding -ffunction-sections -fdata-sections
HOSTED := -Iports -Iports/library -Isrc -I. $(SDL_CFLAGS) $(KMS_CFLAGS)
COMPILE = $(CC) $(FLAGS) $(CPPFLAGS) $(CFLAGS)
LINK    = $(CC) $(OPT) $(ARCH) $(LDFLAGS)
# The faster linker, if installed: tests are hundreds of programs.
GOLD    := $(if $(shell command -v ld.gold),-fuse-ld=gold)
LINK_ELF = $(LINK) -nostdlib -T $(BOARD_LD) -Wl,--gc-sections $(filter %.o,$^) \
           $(LIB) -lgcc -o $@
# Prints one short line for each output; with V=1 the whole command.
SAY     = $(if $(V),,@echo '  $@';)

# On x86-64 the pixel loops are compiled a second time, for processors of level v3:
# tp_program_v3, whose other names are hidden. The tuning makes compilers use gathers.
# V3_C= turns the second copy off.
ifeq ($(firstword $(subst -, ,$(shell $(CC) -dumpmachine 2>/dev/null))),x86_64)
V3_C   := $(filter src/pixel/% src/view/% src/raster/% src/shade/% src/frame/% \
              src/features/all.c %_drawing.c %_stage.c,$(CORE))
V3_OPT := -O3 -march=x86-64-v3 -mtune=skylake
# Files with the same source for both copies: files without loops for vector units.
ifdef V3_SAME_OPT
V3_SAME := $(filter-out $(shell grep -lE 'TP_WIDE|slope\.h"|_plain\.h"' $(V3_C)),$(V3_C))
endif
HOSTED += $(if $(V3_C),-DTP_HAVE_PROGRAM_V3)
endif

# Asserts (src/base/base.h) are off in a release and on with CHECKED=1. Unit tests link
# a library with asserts.
LIB     := $(CORE_AT)/libtidepool.a
HOST_LIB := $(BUILD)/libtidepool-host.a
UNIT_LIB := $(if $(CHECKED),$(LIB),$(BUILD)/checked/libtidepool.a)
PROGRAM := $(BUILD)/tidepool
CORE_O  := $(CORE:%.c=$(CORE_AT)/%.o)
PORTS_O := $(PORTS:%.c=$(BUILD)/%.o) $(if $(V3_C),$(BUILD)/program_v3.o)
PORTS_O := $(PORTS_O:%.cpp=$(BUILD)/%.o)
UNIT    := $(patsubst %.c,$(BUILD)/%,$(wildcard tests/unit/test_*.c tests/host/test_*.c \
               tests/stability/test_*.c tests/accuracy/test_*.c))
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
SCENES  := $(patsubst assets/scenes/%.ini,%,$(wildcard assets/scenes/*.ini))
ONE     := $(if $(filter command,$(firstword $(origin SCENE))),$(SCENE))
# Scenes drawn by tests only.
DRAWN   := $(patsubst tests/golden/scenes/%.ini,%,$(wildcard tests/golden/scenes/*.ini))
# Scenes that each processor must draw with equal frames; together they cover all models.
CROSS   := three-swells raindrops tank pond shore-break deep-sea storm count-64 $(DRAWN)
FRAMES  := $(CROSS:%=$(BUILD)/tests/cross/frames-%)
BAKES   := $(wildcard ports/host/bake*.c ports/host/assets*.c ports/app/files/png_read.c \
               ports/host/scene*.c ports/app/files/ini_read.c src/mesh/*.c \
               src/features/all_rows.c include/tidepool/*.h)
SHIPPED := $(wildcard assets/scenes/*.ini $(addprefix assets/boats/*.,mtl obj png) \
               assets/textures/*.png assets/skies/*.png)

# Files by which other builds find the installed library, as in CMakeLists.txt.
PACKAGES := $(addprefix cmake/tidepool/tidepool-,config.cmake config-version.cmake) \
            pkgconfig/tidepool.pc pkgconfig/tidepool-host.pc
PACKAGED = -e 's|@TP_PREFIX@|../..|; s|@TP_LIBDIR@|lib|; s|@TP_INCLUDEDIR@|include|' \
           -e "s|@TP_VERSION@|$$(sed -n 's/^.define TP_VERSION_M[AI].* //p; \
               s/^.define TP_VERSION_PATCH *//p' include/tidepool/*.h | paste -sd.)|"

# Folder of modules from outside the project; see below.
MORE    ?=
MORE_AT := $(BUILD)/more/$(notdir $(MORE))

# -- targets for users -----------------------------------------------------------------

## build the program, the library and the host library
all: $(PROGRAM) $(LIB) $(HOST_LIB)
## build the program with your own modules: MORE=ports/examples/buoy
more: $(MORE_AT)/tidepool
## build the library alone
lib: $(LIB)
## install missing packages, build, show SCENE; without a display write pictures
run:
	@ports/setup.sh run
	@$(MAKE) --no-print-directory $(PROGRAM)
	@ports/run.sh $(PROGRAM) $(SCENE)
## install the small packages and run the host's tests
test:
	@ports/setup.sh test
	@$(MAKE) --no-print-directory host-tests
## install the other packages and run all tests: processors, boards, windows
test-all:
	@ports/setup.sh all
	@$(if $(TESTED),,$(MAKE) --no-print-directory host-tests)
	@$(MAKE) --no-print-directory more-tests
## run the long tests: random scenes, 300 s of each fuzz target, frames of all builds
soak:
	@ports/setup.sh all
	@$(MAKE) --no-print-directory everything build/host/count.so
	@$(MAKE) --no-print-directory $(SAN) unit
	@TP_SOAK=1 TP_SCENES=100000 FUZZ_SECONDS=$${FUZZ_SECONDS:-300} TP_TIMEOUT=7200 \
	    TP_BUILD=build/san tests/run.sh build/log/soak tests/gates/coverage.sh \
	    tests/cross/run.sh tests/budgets/prices.sh tests/fuzz/run.sh \
	    $(patsubst build/host/%,build/san/%,$(filter $(BUILD)/tests/stability/% \
	        $(BUILD)/tests/accuracy/%,$(UNIT)))
## compare costs of scenes and models with the budgets; SCENE=x by function; WRITE=1
count: $(PROGRAM) build/host/count.so
	@tests/budgets/scenes-count.sh $(if $(WRITE),--write) $(ONE)
	@$(if $(ONE),tests/budgets/host-count.sh $(ONE),tests/budgets/models-count.sh \
	    $(if $(WRITE),--write))
## print the memory of two scenes on a board, by use and tile size
ram: $(PROGRAM) build/host/count.so
	@tests/budgets/ram.sh
## memory, flash and instructions on emulated boards; WRITE=1: into ports/BOARDS.md
boards: $(PROGRAM)
	@tests/boards/table.sh $(if $(WRITE),--write)
## measure time and instructions of the scene for comparison with other renderers
bench: $(PROGRAM) $(BUILD)/tests/bench/scene_s
	@$(PROGRAM) bench
	@tests/bench/run.sh $(BUILD)/tests/bench/scene_s
## find the dearest of 10000 random views, over the median, in instructions
views: $(BUILD)/tests/bench/views build/host/tally.so
	@TP_VIEWS=10000 tests/bench/views.sh
## run the whole sweep of speed against accuracy into assets/charts
charts: charts-tools
	@$(PROGRAM) charts assets/charts
## build the reference renderer: double precision, slow
reference: $(BUILD)/reference
## feed random input to all readers, FUZZ_SECONDS (6) for each
fuzz:
	@tests/fuzz/run.sh
## print line and branch coverage of the core, and the least covered files
coverage:
	@tests/coverage/run.sh
## break the core in N (100) random places by SEED (1), count the detected breaks
mutants:
	@tests/mutants/run.sh $(or $(N),100) $(or $(SEED),1)
## rewrite golden frames and listings; state the reason and the printed PSNR in the commit
golden: $(LISTS) $(BUILD)/tests/golden/test_frames
	for test in $^; do $$test --write || exit 1; done
## draw the README's pictures of all scenes, and the contact sheet
gallery:
	@ports/setup.sh gallery
	@$(MAKE) --no-print-directory $(PROGRAM)
	@ports/gallery.sh $(PROGRAM) assets/gallery
## make the boats and textures again with their generators
assets: $(BUILD)/longship $(BUILD)/textures
	$(BUILD)/longship assets/boats
	$(BUILD)/textures assets/textures assets/skies
## build the web page build/web/index.html, which runs in a browser from its folder
web:
	@ports/setup.sh web
	@$(MAKE) --no-print-directory page
## serve the web page at http://localhost:8080, or at the next free port
serve:
	@ports/setup.sh serve
	@$(MAKE) --no-print-directory page
	@node ports/web/serve.js build/web
## install under PREFIX (/usr/local)
install: all
	install -d $(DESTDIR)$(PREFIX)/bin $(DESTDIR)$(PREFIX)/lib
	install $(PROGRAM) $(DESTDIR)$(PREFIX)/bin
	install -m 644 $(LIB) $(HOST_LIB) $(DESTDIR)$(PREFIX)/lib
	for f in include/tidepool/*.h ports/library/tidepool/*.h; do \
	    install -Dm 644 $$f $(DESTDIR)$(PREFIX)/include/tidepool/$${f##*/} || exit 1; \
	done
	for f in $(PACKAGES); do \
	    to=$(DESTDIR)$(PREFIX)/lib/$$f && install -Dm 644 /dev/null $$to && \
	    sed $(PACKAGED) ports/packages/$${f##*/}.in >$$to || exit 1; \
	done
	for f in 'manual=man/man1/tidepool.1' 'manual --scene=man/man5/tidepool-scene.5' \
	        'completion bash=bash-completion/completions/tidepool' \
	        'completion zsh=zsh/site-functions/_tidepool' \
	        'completion fish=fish/vendor_completions.d/tidepool.fish'; do \
	    to=$(DESTDIR)$(PREFIX)/share/$${f##*=} && install -Dm 644 /dev/null $$to && \
	    $(PROGRAM) $${f%=*} >$$to || exit 1; \
	done
	for f in $(SHIPPED); do \
	    install -Dm 644 $$f $(DESTDIR)$(PREFIX)/share/tidepool/$${f#assets/}; done
## format the sources by .clang-format
format:
	clang-format -i include/tidepool/*.h src/*/*.[ch] src/*/*/*.[ch] ports/*/*.[ch] \
	    ports/*/*/*.[ch] tests/*/*.[ch]
## remove all build output
clean:
	rm -rf build out
## print this list
help:
	@awk '/^## / { text = substr($$0, 4); getline; sub(/:.*/, ""); \
	    printf "  %-10s %s\n", $$0, text }' Makefile

# -- tests -----------------------------------------------------------------------------

# Tests run under the sanitizers only, except: the golden frames also run without, since
# the shipped library must draw them; tests that measure errors run without sanitizers
# unless in the soak; threads have a test of their own. The second copy of the pixel loops
# is compiled with light optimisation, and sanitized only where its source differs from
# the first copy.
V3_LITE := V3_OPT='-O1 -march=x86-64-v3'
SAN := TARGET=san OPT='-O1 -g1 -fsanitize=address,undefined -fno-sanitize-recover=all' \
       $(V3_LITE) V3_SAME_OPT=-fno-sanitize=all CHECKED=1
SAN_UNIT := $(filter-out $(BUILD)/tests/accuracy/% %/test_features_water_quick_light \
               %/test_features_water_quick_even %/test_threads,$(UNIT))
RUN := TP_BUILD=$(BUILD) TP_PROGRAM=$(PROGRAM) TP_LEFT_OUT='$(LEFT_OUT)' tests/run.sh

unit: $(UNIT)
sanitized: $(SAN_UNIT) $(GOLDEN) $(PROGRAM) $(PANEL_DEMO)
everything: all $(PANEL_DEMO) $(filter-out $(SAN_UNIT),$(UNIT)) $(GOLDEN) $(FRAMES) \
          $(BUILD)/tests/bench/scene_s \
          $(BUILD)/tests/bench/views $(BUILD)/longship $(BUILD)/textures \
          $(addprefix $(BUILD)/tests/host/,same_pixels apng_frames furniture saves) \
          $(BUILD)/screen_fake.so $(BUILD)/faults.so \
          $(addprefix $(BUILD)/tests/,host/screen_crc boards/same_picture \
              boards/oled_greys boards/vm_state)
host-tests: everything
	@$(MAKE) --no-print-directory $(SAN) sanitized
	@$(RUN) build/log/host tests/gates/sanitized.sh tests/host/saves.sh \
	    tests/host/screen.sh $(SAN_UNIT:build/host/%=build/san/%) \
	    $(filter-out $(SAN_UNIT),$(UNIT)) $(GOLDEN) $(GOLDEN:build/host/%=build/san/%) \
	    $(if $(LEFT_OUT),tests/gates/left-out.sh) tests/gates/host.sh \
	    tests/gates/headers.sh tests/gates/glossary.sh tests/gates/words.sh \
	    tests/gates/selftest.sh tests/mutants/selftest.sh \
	    tests/host/cli.sh \
	    tests/host/manual.sh tests/host/exits.sh tests/host/output.sh tests/host/bake.sh \
	    tests/host/check.sh tests/host/check_ranges.sh tests/host/tape.sh \
	    tests/host/own_module.sh tests/host/charts.sh tests/host/linked.sh \
	    tests/host/packages.sh tests/host/library.sh \
	    tests/host/charts_stop.sh tests/boards/readme.sh \
	    tests/host/generators.sh tests/host/readme.sh tests/host/examples.sh
# Builds first what several tests need from the board's compiler; the longest tests begin
# first.
more-tests: everything build/host/count.so build/host/tally.so
	@! command -v arm-none-eabi-gcc >/dev/null || \
	    for goals in 'BOARD=cortex-m elves' 'BOARD=cortex-m/microbit lib' \
	            'BOARD=cortex-m/lm3s6965evb lib' charts-tools; do \
	        $(MAKE) --no-print-directory $$goals || exit 1; \
	    done
	@$(RUN) build/log/more tests/cross/run.sh tests/fuzz/run.sh tests/boards/cortex-m.sh \
	    tests/gates/arm.sh tests/gates/clang.sh tests/gates/coverage.sh \
	    tests/host/view.sh tests/host/panel.sh tests/host/view_keys.sh \
	    tests/host/leaks.sh tests/host/furniture.sh tests/web/web.sh \
	    tests/host/threads.sh tests/bench/views.sh tests/cross/film.sh \
	    $(patsubst %,tests/boards/%.sh,rpi oled control linuxfb kms kms_events console) \
	    tests/charts/sweep.sh tests/budgets/prices.sh tests/budgets/models-count.sh \
	    tests/budgets/scenes-count.sh tests/budgets/ram.sh tests/budgets/programs.sh \
	    tests/charts/same.sh tests/budgets/plan-count.sh
fuzzers: $(FUZZ)
# Other renderers for `tidepool bench --peers`, as far as their packages are installed.
PEERS := $(BUILD)/tests/bench/peers
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
elf: $(BUILD)/scenes/$(SCENE).elf
elves: $(SCENES:%=$(BUILD)/scenes/%.elf)
frames: $(FRAMES)
list-core:
	@echo $(CORE)
list-scenes:
	@echo $(SCENES)
list-cross:
	@echo $(CROSS)
list-tests:
	@for test in $(patsubst $(BUILD)/%,%,$(UNIT) $(GOLDEN)) $(LEFT_OUT); do \
	    echo $$test; \
	done

# -- rules -----------------------------------------------------------------------------

ASSERT_O := $(BUILD)/tests/lib/assert_failed.o
$(LIB): $(CORE_O) $(if $(CHECKED),$(ASSERT_O))
$(BUILD)/checked/libtidepool.a: $(CORE:%.c=$(BUILD)/checked/%.o) $(ASSERT_O)
$(BUILD)/ports.a: $(PORTS_O)
%.a:
	@rm -f $@
	$(SAY)$(AR) rcs $@ $^
# The host library: the parts of the ports that it uses, with only the public names
# visible.
$(HOST_LIB): $(BUILD)/host-library.o
$(BUILD)/host-library.o: $(patsubst %.c,$(BUILD)/%.o,$(wildcard ports/library/*.c)) \
          $(BUILD)/ports.a
	$(SAY)$(LD) -r $^ -o $@
	@$(OBJCOPY) --wildcard --keep-global-symbol='tp_host_*' $@
# The core as a shared library for tests: tests/mutants/run.sh links with it. The path is
# absolute, since some tests run a copy of themselves in another folder.
%.so:
	@mkdir -p $(@D)
	$(SAY)$(LINK) -shared -Wl,-soname,$(abspath $@) $^ -o $@
$(PROGRAM): $(MAIN:%.c=$(BUILD)/%.o) $(BUILD)/ports.a $(LIB)
	$(SAY)$(LINK) $^ $(LIBS) -o $@
# The program with modules from outside the project: MORE is their folder, and its list.h
# lists them. Files that read the library's module list or its parameter table are
# compiled again.
MORE_O  := $(patsubst %.c,$(MORE_AT)/%.o,src/features/all.c src/features/all_rows.c \
               $(addprefix ports/host/,machine.c pieces.c stopwatch.c) \
               $(wildcard $(addsuffix /*.c,$(MORE))))
$(MORE_AT)/tidepool: $(MAIN:%.c=$(BUILD)/%.o) $(MORE_O) $(BUILD)/ports.a $(LIB)
	$(SAY)$(LINK) $^ $(LIBS) -o $@
$(MORE_O): $(MORE_AT)/%.o: %.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(SAY)$(COMPILE) $(HOSTED) -UTP_HAVE_PROGRAM_V3 -DTP_MORE='"$(MORE)/list.h"' -c $< -o $@
$(BUILD)/tests/boards/vm_state: $(BUILD)/tests/boards/vm_state.o
	$(SAY)$(LINK) -static $^ -o $@
$(UNIT): $(UNIT_LIB)
$(BUILD)/tests/%: $(BUILD)/tests/%.o $(BUILD)/ports.a $(LIB)
	$(SAY)$(LINK) $(GOLD) $(filter %.o,$^) $(BUILD)/ports.a \
	    $(or $(filter $(UNIT_LIB),$^),$(LIB)) $(CMOCKA) $(LIBS) -o $@
$(filter $(BUILD)/%,$(GOLDEN)): $(BUILD)/tests/lib/golden.o
LCD_O := $(patsubst %,$(BUILD)/%.o,$(addprefix ports/lcd/,clear lcd panels ssd0323 turn) \
               tests/lib/lcd_panel tests/lib/golden)
$(filter $(BUILD)/tests/host/test_lcd%,$(UNIT)): $(LCD_O)
$(BUILD)/tests/boards/sent: $(filter %/clear.o %/lcd.o %/panels.o %/turn.o,$(LCD_O))
$(BUILD)/tests/host/test_kms: $(BUILD)/tests/host/fake_kms.o
$(BUILD)/reference: $(BUILD)/tests/reference/reference.o $(BUILD)/ports.a $(LIB)
	$(SAY)$(LINK) $^ $(LIBS) -o $@
# Fuzz targets: all readers of bytes, in the core and the ports.
$(FUZZ): $(BUILD)/%: $(BUILD)/%.o $(BUILD)/ports.a $(LIB)
	$(SAY)$(LINK) -fsanitize=fuzzer -Wl,--as-needed $(filter %.o,$^) $(BUILD)/ports.a \
	    $(LIB) $(LIBS) -o $@
$(BUILD)/longship: $(patsubst %.c,$(BUILD)/%.o,$(wildcard assets/boats/*.c) \
          assets/textures/canvas.c)
	$(SAY)$(LINK) $^ -lpng -lm -o $@
$(BUILD)/textures: $(patsubst %.c,$(BUILD)/%.o,$(wildcard assets/textures/*.c))
	$(SAY)$(LINK) $^ -lpng -o $@
# Scenes as constants, for machines without files: built once for each processor, and
# again when the code that writes them changes. SCENE=harbour@32 limits textures to 32
# texels a side.
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
$1/%.c: $3 $$(BAKED_FROM)
	$(call bake,assets/scenes/$$(basename $$(@F)).ini,$2)
$1/board-%.c: tests/budgets/board-%.ini $3 $$(BAKED_FROM)
	$(call bake,$$<,$2)
endef
define baked_at
$1/%@$4.c: $5/%.ini $3 $$(BAKED_FROM)
	$(call bake,$$<,$2 --texels $4)
endef
baked = $(eval $(call baked_in,$1,$2,$3)) $(foreach n,16 32 64 128,$(foreach folder, \
    assets/scenes ports/cortex-m/scenes tests/budgets, \
        $(eval $(call baked_at,$1,$2,$3,$n,$(folder)))))
$(call baked,build/baked)
# A board's baked scenes include the module list for the link, which depends on all
# drawing code.
ifdef BAKE
$(call baked,$(BUILD)/baked,$(BAKE),build/host/tidepool ports/$(BOARD)/board.mk)
endif
build/baked/prices.c: tests/budgets/prices.ini $(BAKES) $(SHIPPED) | build/host/tidepool
	@mkdir -p $(@D)
	$(SAY)build/host/tidepool bake $< --name baked -o $@
build/baked/$(MACHINE)/%.o: build/baked/%.c
	@mkdir -p $(@D)
	$(SAY)$(COMPILE) -c $< -o $@
$(BUILD)/baked/%.o: $(BUILD)/baked/%.c $(BUILD)/flags
	$(SAY)$(COMPILE) -c $< -o $@
# Builds the host program if it is missing, without the variables for boards and
# compilers.
ifneq ($(PROGRAM),build/host/tidepool)
build/host/tidepool build/host/tests/charts/pool_points:
	@env -i PATH="$$PATH" HOME="$$HOME" $(MAKE) -j2 --no-print-directory $@
endif
$(patsubst %,$(BUILD)/tests/cross/frames-%,$(SCENES) $(DRAWN)): \
          $(BUILD)/tests/cross/frames-%: $(BUILD)/tests/cross/frames.o \
          build/baked/$(MACHINE)/%.o $(LIB)
	$(SAY)$(LINK) $^ -o $@
# The film program: of the tools only the parts for films.
FILM_O  := $(addprefix $(BUILD)/ports/host/,atomic_file.o film.o output.o path.o \
               picture.o say.o)
$(SCENES:%=$(BUILD)/tests/cross/film-%): \
          $(BUILD)/tests/cross/film-%: $(BUILD)/tests/cross/film.o $(FILM_O) \
          build/baked/$(MACHINE)/%.o $(LIB)
	$(SAY)$(LINK) $^ -o $@
# The program for raw screens: one static file for a small Linux board.
SCREEN_O := $(patsubst %.c,$(BUILD)/%.o,$(filter ports/linuxfb/% ports/kms/% \
               ports/screen/%,$(PORTS)) ports/app/fullscreen/baked_main.c $(addprefix ports/host/, \
               atomic_file.c hashes.c picture.c say.c streams.c timing.c) \
               ports/interact/input_merge.c)
$(SCENES:%=$(BUILD)/scenes/%-screen): $(BUILD)/scenes/%-screen: $(SCREEN_O) \
          build/baked/$(MACHINE)/%.o $(LIB)
	@mkdir -p $(@D)
	$(SAY)$(LINK) -static $^ -lpthread -o $@
$(BUILD)/tests/host/apng_frames: LIBS += -lz
$(BUILD)/tests/budgets/errors: $(BUILD)/tests/budgets/errors.o $(BUILD)/ports.a $(LIB)
	$(SAY)$(LINK) $^ $(LIBS) -o $@
MODELS_O := $(patsubst %.c,$(BUILD)/%.o,$(wildcard tests/budgets/models*.c))
# Uses the board's mem*: the C library selects its own at run time by the processor.
$(BUILD)/tests/budgets/models: $(MODELS_O) $(BUILD)/ports/cortex-m/memory.o $(LIB)
	$(SAY)$(LINK) $^ -o $@
build/host/count.so: tests/budgets/count.c $(BUILD)/flags
	$(SAY)$(COMPILE) -D_POSIX_C_SOURCE=200809L -fPIC -shared $< -o $@
$(BUILD)/screen_fake.so $(BUILD)/faults.so: $(BUILD)/%.so: tests/host/%.c $(BUILD)/flags
	$(SAY)$(COMPILE) -fPIC -shared $< -ldl -o $@
build/host/tally.so: tests/bench/tally.c $(BUILD)/flags
	$(SAY)$(COMPILE) -fPIC -shared $< -o $@
BOARD_O := $(addprefix $(BUILD)/,$(addsuffix .o,$(basename $(BOARD_C))))
$(BUILD)/scenes/%.elf: $(if $(BAKE),$(BUILD)/baked,build/baked/$(MACHINE))/%.o \
          $(BOARD_O) $(LIB) $(LD_FILES)
	@mkdir -p $(@D)
	$(SAY)$(LINK_ELF) -Wl,-Map=$(@:.elf=.map)
$(BUILD)/prices.elf: $(BUILD)/tests/budgets/prices.o build/baked/$(MACHINE)/prices.o \
          $(filter-out %/main.o,$(BOARD_O)) $(LIB) $(LD_FILES)
	$(SAY)$(LINK_ELF)
$(BUILD)/ram/%.elf: $(BUILD)/tests/budgets/ram.o build/baked/$(MACHINE)/%.o \
          $(filter-out %/main.o,$(BOARD_O)) $(LIB) $(LD_FILES)
	@mkdir -p $(@D)
	$(SAY)$(LINK_ELF)
FAULTS  := $(addprefix $(BUILD)/faults/,address instruction stack ram)
$(FAULTS:%=%.o): $(BUILD)/faults/%.o: tests/boards/faults.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(SAY)$(COMPILE) $(HOSTED) -DFAULT_$* -c $< -o $@
$(FAULTS:%=%.elf): $(BUILD)/faults/%.elf: $(BUILD)/faults/%.o \
          $(filter-out %/main.o %/sum.o,$(BOARD_O)) $(LIB) $(LD_FILES)
	$(SAY)$(LINK_ELF)
$(BUILD)/models.elf: $(MODELS_O) \
          $(filter-out %/main.o,$(BOARD_O)) $(LIB) $(LD_FILES)
	$(SAY)$(LINK_ELF)
$(BUILD)/program_v3.o: $(V3_C:%.c=$(BUILD)/v3/%.o)
	$(SAY)$(LD) -r $^ -o $@
	@$(OBJCOPY) --keep-global-symbol=tp_program_v3 $@
$(BUILD)/checked/src/%.o: src/%.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(SAY)$(COMPILE) $(BARE) -DTP_CHECKED -c $< -o $@
$(BUILD)/v3/src/%.o: src/%.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(SAY)$(COMPILE) $(BARE) $(V3_OPT) -Dtp_program_all=tp_program_v3 \
	    $(if $(filter $<,$(V3_SAME)),$(V3_SAME_OPT)) -c $< -o $@
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
$(PROGRAMS:%=%.elf): %.elf: %.o $(BUILD)/tests/budgets/minimal.o \
          $(filter-out %/main.o,$(BOARD_O)) $(LIB) $(LD_FILES)
	$(SAY)$(LINK_ELF) -Wl,-Map=$(@:.elf=.map)

$(CORE_AT)/src/%.o: src/%.c $(CORE_AT)/flags
	@mkdir -p $(@D)
	$(SAY)$(COMPILE) $(BARE) -c $< -o $@
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
	@echo '$(COMPILE) $(SDL_CFLAGS)' | cmp -s - $@ || echo '$(COMPILE) $(SDL_CFLAGS)' >$@

include tests/charts/charts.mk
include ports/web/web.mk

.PHONY: all lib run test test-all soak count ram boards bench views charts reference \
    fuzz coverage mutants golden gallery assets install format clean help unit \
    sanitized everything host-tests more-tests fuzzers peers charts-tools elf elves \
    frames programs more list-core list-scenes list-cross list-tests force
.SECONDARY:
-include $(shell find $(sort $(BUILD) $(CORE_AT)) -name '*.d' 2>/dev/null)
