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
TESTS_OPT ?= -O1
ARCH    ?=
PREFIX  ?= /usr/local
SCENE   ?= three-swells
# The scene, if named: make count SCENE=tank
ONE     := $(if $(filter command,$(firstword $(origin SCENE))),$(SCENE))
# Folder of modules from outside the project.
MORE    ?=
OBJCOPY ?= objcopy
# The values given for `make new-board`, quoted for the shell.
given    = $(if $(filter command,$(firstword $(origin $1))),'$1=$(subst ','\'',$($1))')
NEW_BOARD = $(strip $(foreach name,CPU DIR SCENE SIZE PANEL PICTURE MEMORY FLASH RAM, \
               $(call given,$(name))))
# Tests are built on all processors, unless make was called with -j.
BUILDS   = $(MAKE) --no-print-directory $(if $(filter -j%,$(MAKEFLAGS)),,-j$(shell nproc))
all:

include ports/compile.mk
include src/core.mk
include ports/ports.mk
include ports/boards.mk
include ports/packages/install.mk
include ports/web/web.mk
include tests/tests.mk
include tests/cross/cross.mk
include tests/boards/boards.mk
include tests/budgets/budgets.mk
include tests/charts/charts.mk

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
## install the small packages and run the quick tests: 150 s on two processors
test:
	@ports/setup.sh test
	+@$(BUILDS) quick-tests
## install the other packages and run all tests: sanitizers, processors, boards, windows
test-all:
	@ports/setup.sh all
	+@$(if $(TESTED),,$(BUILDS) quick-tests)
	+@$(BUILDS) more-tests
## run the long tests: random scenes, 300 s of each fuzz target, frames of all builds
soak:
	@ports/setup.sh all
	+@$(BUILDS) soak-tests
## compare costs of scenes and models with the budgets; SCENE=x by function; WRITE=1
count: $(PROGRAM) build/host/count.so
	@tests/budgets/scenes-count.sh $(if $(WRITE),--write) $(ONE)
	@$(if $(ONE),tests/budgets/host-count.sh $(ONE),tests/budgets/models-count.sh \
	    $(if $(WRITE),--write))
## print the memory of two scenes on a board, by use and tile size
ram: $(PROGRAM) build/host/count.so
	@tests/budgets/ram.sh
## memory, flash and instructions on emulated boards; WRITE=1: into the pages' tables
boards: $(PROGRAM)
	@tests/boards/table.sh $(if $(WRITE),--write)
## start a project for another board: CPU=cortex-m4 DIR=../myboard; usage without them
new-board:
	@ports/new_board.sh --check $(NEW_BOARD)
	@$(if $(NEW_BOARD),$(MAKE) --no-print-directory $(PROGRAM))
	@$(if $(NEW_BOARD),ports/new_board.sh $(NEW_BOARD))
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
	@tests/charts/choices.sh --write
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

.PHONY: all more lib run test test-all soak count ram boards new-board bench views charts \
    reference fuzz coverage mutants golden gallery assets web serve install format clean help
