#!/bin/sh
# SPDX-License-Identifier: MIT
# Tests of the gates: each gate gets a good example and some bad ones.
. "$(dirname "$0")/../lib/script.sh"

mkdir -p "$scratch/src/fixed" "$scratch/src/waves" "$scratch/src/pool" "$scratch/src/odd" \
    "$scratch/include/tidepool" "$scratch/ports/app/preview"

# put FILE LINE...: writes a file with these lines under a licence line.
put()
{
    file=$scratch/$1; shift
    printf '%s\n' '/* SPDX-License-Identifier: MIT */' "$@" >"$file"
}

layers()    { awk -f $gates/layers.awk "$scratch/$1"; }
words()     { awk -f $gates/words.awk "$scratch/$1"; }
text()      { awk -f $gates/text.awk "$scratch/$1"; }

put src/waves/a.c '#include "fixed/fx_table.inc"' '#include "waves/deep_water.h"' \
    '#include <stdint.h>'
check  "layers: passes includes that point down" layers src/waves/a.c
put src/fixed/a.c '#include "waves/deep_water.h"'
refuse "layers: an include that points up" layers src/fixed/a.c
put src/waves/b.c '#include "pool/pool.h"'
refuse "layers: a peer" layers src/waves/b.c
put src/waves/c.c '#include "tidepool/frame.h"'
refuse "layers: a public header of a higher rank" layers src/waves/c.c
put src/waves/d.c '#include "wave.h"'
refuse "layers: a name not written from src" layers src/waves/d.c
put src/waves/e.c '# include <stdio.h>'
refuse "layers: the C library in the core" layers src/waves/e.c
put src/waves/f.c '#include "app/files/log.h"'
refuse "layers: a port in the core" layers src/waves/f.c
put src/odd/a.c ''
refuse "layers: a folder without a rank" layers src/odd/a.c
put include/tidepool/fixed.h '#include "base/base.h"'
refuse "layers: an internal header in a public one" layers include/tidepool/fixed.h
put include/tidepool/scene.h '#include "tidepool/frame.h"'
refuse "layers: a public header that points up" layers include/tidepool/scene.h
mkdir -p "$scratch/src/pixel" "$scratch/ports/lcd" "$scratch/ports/rpi"
put src/pixel/a.c '#include "tidepool/frame.h"'
check  "layers: passes a public header that is seen for its types" layers src/pixel/a.c
put ports/lcd/a.c '#include "base/base.h"'
refuse "layers: the core's inside in a port" layers ports/lcd/a.c
put ports/rpi/a.c '#include "base/base.h"'
check  "layers: passes a header of the core that a port is granted" layers ports/rpi/a.c
put ports/rpi/b.c '#include "base/dsp.h"'
refuse "layers: another header of the same folder" layers ports/rpi/b.c
put ports/app/preview/a.c '#include "fixed/arithmetic.h"'
check  "layers: passes the core's inside in a tool" layers ports/app/preview/a.c
put ports/app/preview/b.c '#include "tidepool/tidepool.h"' '#include <SDL.h>' \
    '#include "app/files/log.h"'
check  "layers: passes a port that keeps to the API" layers ports/app/preview/b.c

mkdir -p "$scratch/ports/cortex-m"
put ports/cortex-m/a.c '#include "serial/control.h"' '#include "lcd/lcd.h"'
check  "layers: passes what boards share" layers ports/cortex-m/a.c
put ports/cortex-m/b.c '#include "app/files/log.h"'
refuse "layers: the host program in a board" layers ports/cortex-m/b.c

mkdir -p "$scratch/src/features/buoy" "$scratch/src/features/kite" "$scratch/src/world"
features() { awk -f $gates/features.awk "$scratch/src/features/buoy/buoy.c" "$scratch/$1"; }
put src/features/buoy/buoy.c '#include "features/buoy/buoy.h"' \
    'const tp_module tp_buoy_module = { 0 };' 'void tp_buoy_step(void) { tp_buoy_sway(); }'
put src/features/buoy/sway.c '#include "features/buoy/buoy.h"' 'void f(void) { tp_buoy_sway(); }'
check  "features: passes a feature's own files" features src/features/buoy/sway.c
put src/features/all.c '#include "features/buoy/buoy.h"'
check  "features: passes the list" features src/features/all.c
put src/world/a.c '#include "features/buoy/buoy.h"'
refuse "features: a feature's header outside of its folder" features src/world/a.c
put src/features/kite/a.c '#include "features/buoy/buoy.h"'
refuse "features: another feature's header" features src/features/kite/a.c
put src/world/b.c 'void f(void) { tp_buoy_step(); }'
refuse "features: a feature's function outside of its folder" features src/world/b.c

put src/waves/g.c '/* a double */ int x; /* free' ' float */ const char *s = "malloc";'
check  "words: passes comments and strings" words src/waves/g.c
put src/waves/h.c '/* fine */ double x;'
refuse "words: a double" words src/waves/h.c
put src/waves/i.c 'int f(void) { return (int)(float)3; }'
refuse "words: a cast to float" words src/waves/i.c
put src/waves/j.c 'void *p = malloc(3);'
refuse "words: the heap" words src/waves/j.c

put src/waves/j1.c 'int f(int *p) { return __atomic_fetch_add(p, 1, 0); }'
refuse "words: a lock" words src/waves/j1.c

check  "text: passes a plain file" text src/waves/a.c
printf 'int x;\nint y;\nint z;\n' >"$scratch/src/waves/k.c"
refuse "text: no licence line" text src/waves/k.c
put src/waves/l.c "$(printf 'int\tx;')" ''
refuse "text: a tab" text src/waves/l.c
put src/waves/m.c 'int x; ' ''
refuse "text: a blank at the end" text src/waves/m.c
put src/waves/n.c "/* $(printf '%0100d' 0) */" ''
refuse "text: a line too long" text src/waves/n.c

headers()   { headers_alone gcc g++ "$scratch/$1"; }
mkdir -p "$scratch/one/tidepool"
put one/tidepool/a.h '#ifndef TP_A_H' '#define TP_A_H' 'typedef struct { int x; } tp_a;' '#endif'
check  "headers: passes one that is C and C++" headers one
put one/tidepool/a.h '#ifndef TP_A_H' '#define TP_A_H' \
    'typedef struct { int n, x[]; } tp_a;' '#endif'
refuse "headers: an array without a size, which C++ lacks" headers one
put one/tidepool/a.h 'typedef struct { int x; } tp_a;'
refuse "headers: one that cannot be included twice" headers one
put one/tidepool/a.h '#ifndef TP_A_H' '#define TP_A_H' 'extern uint32_t tp_a;' '#endif'
refuse "headers: one that leans on another" headers one

# compile NAME TEXT: makes NAME.a and NAME.ci in the scratch folder.
compile()
{
    printf '%s\n' "$2" >"$scratch/$1.c"
    gcc -std=c11 -O2 -ffreestanding -fno-optimize-sibling-calls -fstack-usage \
        -fcallgraph-info=su -c "$scratch/$1.c" -o "$scratch/$1.o" 2>/dev/null &&
        rm -f "$scratch/$1.a" && ar rcs "$scratch/$1.a" "$scratch/$1.o"
}
stack()     { no_deeper "$2" "$scratch/$1.ci"; }

compile good 'void *memcpy(void *, const void *, unsigned long);
    static const int t[3] = { 1, 2, 3 };
    int tp_f(int i, void *a, void *b) { memcpy(a, b, 64 + (unsigned)i); return t[i]; }'
check  "symbols: passes mem*" symbols "" "$scratch/good.a"
check  "state: passes constants" no_state "" "$scratch/good.a"
check  "floats: passes whole numbers" no_floats "$scratch/good.a"
check  "stack: passes a small frame" stack good 256
compile lone 'int printf(const char *, ...); int tp_f(void) { return printf(""); }'
refuse "symbols: a call of the C library" symbols "" "$scratch/lone.a"
compile loud 'int helper(void) { return 1; }'
refuse "symbols: a public name without tp_" symbols "" "$scratch/loud.a"
compile state 'static int n; int tp_f(void) { return ++n; }'
refuse "state: a counter in .bss" no_state "" "$scratch/state.a"
compile data 'static int n = 7; int tp_f(void) { return ++n; }'
refuse "state: a counter in .data" no_state "" "$scratch/data.a"
case $(uname -m) in
x86_64)
    compile float 'int tp_f(int a) { return (int)(a * 1.5f); }'
    refuse "floats: a product" no_floats "$scratch/float.a" ;;
esac
printf 'int tp_f(int a) { return (int)(a * 1.5f); }\n' >"$scratch/soft.c"
soft_float()
{
    gcc -O2 -mgeneral-regs-only -c "$scratch/soft.c" -o "$scratch/soft.o" &&
        symbols "" "$scratch/soft.o"
}
refuse "symbols: a soft-float call" soft_float
compile big 'int tp_f(int *p); int tp_g(void) { int a[999]; return tp_f(a) + a[3]; }'
refuse "stack: a large frame" stack big 256
compile deep 'int tp_g(int n, int *p);
    int tp_f(int n, int *p) { return n < 2 ? n : tp_g(n - 1, p) + *p; }
    int tp_g(int n, int *p) { return n < 3 ? n : tp_f(n - 2, p) * *p; }'
refuse "stack: two functions that call each other" stack deep 4096
compile vla 'void tp_f(int *p); void tp_g(int n) { int a[n]; tp_f(a); }'
refuse "stack: a frame of unknown size" stack vla 4096
compile table 'int tp_f(int (*f[])(int), int i) { return f[i](i) + 1; }'
refuse "stack: a pointer that leads nobody knows where" stack table 4096
compile ring 'int tp_stage_x(int (*f[])(int), int i);
    int shade_row(int (*f[])(int), int i) { return f[i](i) + 1; }
    int tp_stage_x(int (*f[])(int), int i) { return shade_row(f, i) + 2; }'
refuse "stack: recursion through a pointer" stack ring 4096

asserts()   { awk -v least=5 -v most=300 -f $gates/asserts.awk "$scratch/$1"; }
put src/pool/a.c 'int f(int *p, int n) {' '    TP_ASSERT(p != NULL' '              && n == 1);' \
    '    return *p; }'
check  "asserts: passes a comparison" asserts src/pool/a.c
put src/pool/b.c 'int f(int n) { TP_ASSERT(n++ < 3); return n; }'
refuse "asserts: a step" asserts src/pool/b.c
put src/pool/c.c 'int f(int n) { TP_ASSERT(n = 3); return n; }'
refuse "asserts: an assignment" asserts src/pool/c.c
put src/pool/d.c 'int f(int n) { TP_ASSERT(g(n) == 3); return n; }'
refuse "asserts: a call that may have an effect" asserts src/pool/d.c
put src/pool/e.c 'int f(int n) { return n; }'
refuse "asserts: code without any" asserts src/pool/e.c

# assert_by FLAG...: a program whose assert fails; prints its output and its exit code.
cat >"$scratch/broken.c" <<'END'
#include "base/base.h"
int main(int count, char **words) { TP_ASSERT(count == 0); return words == 0; }
END
assert_by()
{
    gcc -std=c11 -Wall -Wextra -Werror -Iinclude -Isrc "$@" "$scratch/broken.c" \
        tests/lib/assert_failed.c -o "$scratch/broken" || return 2
    "$scratch/broken" >"$scratch/said" 2>&1
}
spoken() { ! assert_by -DTP_CHECKED && grep -q 'broken.c:2: .*count == 0' "$scratch/said"; }
check  "asserts: a checked build tells which one, and ends" spoken
check  "asserts: a release does not evaluate them" assert_by
echo '#define TP_ASSERT(x) do { if (!(x)) return 7; } while (0)' >"$scratch/own.h"
other()  { assert_by -include "$scratch/own.h"; [ $? -eq 7 ]; }
check  "asserts: a header may define them otherwise" other

runner()    { tests/run.sh "$scratch/log" "$scratch/$1"; }
fake()      { printf '#!/bin/sh\n%s\n' "$2" >"$scratch/$1"; chmod +x "$scratch/$1"; }
fake fine   'echo "ok - a"; echo "ok - b"'
check  "runner: passes" runner fine
fake says   'echo "ok - a"; echo "FAILED - b"'
refuse "runner: a case that failed, in a script that exits with 0" runner says
fake dies   'echo "ok - a"; kill -SEGV $$'
refuse "runner: a crash" runner dies
fake void   ':'
refuse "runner: no case at all" runner void
fake skips  'echo "ok - a"; echo "skipped: b (package c)"'
check  "runner: a skip is no failure" \
    env TP_STRICT= tests/run.sh "$scratch/log" "$scratch/skips"
refuse "runner: a skip is a failure under TP_STRICT" \
    env TP_STRICT=1 tests/run.sh "$scratch/log" "$scratch/skips"

# tells STRICT TEST PATTERN: the runner runs FINE and TEST, and prints a matching line.
tells()
{
    env TP_STRICT="$1" tests/run.sh "$scratch/log" "$scratch/fine" "$scratch/$2" \
        >"$scratch/told" 2>&1 || { cat "$scratch/told"; return 1; }
    grep -qx "$3" "$scratch/told" || { cat "$scratch/told"; return 1; }
}
fake lacks  'echo "skipped: screens (package libdrm-dev)"; exit 77'
check  "runner: exit 77 is a skip" tells "" lacks '2 passed, 0 failed, 1 skipped'
check  "runner: the reason of a skip is printed" \
    tells "" lacks 'skipped: screens (package libdrm-dev)'
refuse "runner: exit 77 is a failure under TP_STRICT" tells 1 lacks '.*'
fake mute   'exit 77'
check  "runner: exit 77 without a reason is counted" \
    tells "" mute '2 passed, 0 failed, 1 skipped'
check  "runner: exit 77 without a reason is printed" tells "" mute 'skipped: .*mute (.*)'
fake both   'echo "FAILED - a"; echo "skipped: b (package c)"; exit 77'
refuse "runner: a failed case fails in a test that exits with 77" tells "" both '.*'

# Without libraries the Makefile builds fewer tests, and reports the missing tests by
# name.
every_test()    # LIBRARIES: pkg-config knows only these; no kernel headers
{
    for library in $1; do
        cp "$(pkg-config --variable=pcfiledir "$library")/$library.pc" "$scratch/pc/" ||
            return 1
    done
    PKG_CONFIG_LIBDIR=$scratch/pc build -s KMS_CFLAGS= list-tests >"$scratch/tests" &&
        ls tests/*/test_*.c | sed 's/\.c$//' >"$scratch/sources" &&
        sed 's/=.*//' "$scratch/tests" | sort | diff "$scratch/sources" -
}
tells_of()      # TEST PACKAGE
{
    TP_LEFT_OUT=$(grep = "$scratch/tests") tests/gates/left-out.sh >"$scratch/left" ||
        [ $? = 77 ] && grep -qxF "skipped: $1 (package $2)" "$scratch/left"
}
mkdir "$scratch/pc"
if pkg-config --exists cmocka; then
    check "left out: every test is built or told of" every_test cmocka
    check "left out: tests of a window" tells_of tests/host/test_window libsdl2-dev
    check "left out: tests of its panel" tells_of tests/host/test_panel_rows libsdl2-dev
    check "left out: tests of raw screens" tells_of tests/host/test_kms libdrm-dev
    rm "$scratch/pc/cmocka.pc"
fi
check  "left out: every test is told of where no library is" every_test ""
check  "left out: unit tests" tells_of tests/unit/test_fixed_angles libcmocka-dev
check  "left out: golden frames" tells_of tests/golden/test_frames libcmocka-dev
finish
