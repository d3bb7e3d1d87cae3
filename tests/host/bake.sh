#!/bin/sh
# SPDX-License-Identifier: MIT
# Scenes baked to constant C: every shipped scene compiles without a warning and draws the
# same picture as the program.  A scene that cannot be baked is refused, and no file is
# left.
#     bake.sh PROGRAM
root=$PWD
. "$(dirname "$0")/../lib/script.sh"
program_begin "$1"

# absent NAME: expects that bake has left no file.
absent() {
    same "$1" "$(ls -A | grep '\.c$\|tidepool-')" ""
}

# -- refused scenes -------------------------------------------------------------------

expect "no scene to bake" 2 "SCENE is missing" bake -o a.c
expect "no file to bake into" 2 "o FILE.c is missing" bake minimal
expect "-o without its value" 2 "needs a value" bake minimal -o
expect "a size that is too small" 2 "16..4096" bake minimal -o a.c --size 15x16
expect "a size that is too large" 2 "16..4096" bake minimal -o a.c --size 16x4097
expect "a format of nobody" 2 "expected xrgb8888" bake minimal -o a.c --format rgb888
for option in with without; do
    expect "--$option of what is no piece" 2 "--$option fome: no such module; did you mean" \
        bake minimal -o a.c --size 32x32 "--$option" ripple,fome
    expect "--$option of an empty name" 2 "--$option" \
        bake minimal -o a.c --size 32x32 "--$option" ""
done
expect "a piece that is wanted and not" 2 "foam is in both --with and --without" \
    bake minimal -o a.c --size 32x32 --with foam --without foam
expect "a list of no size and format" 2 "--with is an option of the program" \
    bake minimal -o a.c --with foam
for name in 3x a-b tp tp_x "" "a b" ä; do
    expect "the name '$name'" 2 "expected a C identifier" bake minimal -o a.c --name "$name"
done
for texels in 0 -1 4097 x; do
    expect "$texels texels" 2 "1..4096" bake minimal -o a.c --texels "$texels"
done
expect "a scene that is not there" 3 "did you mean harbour" bake harbor -o a.c
printf '[water]\nclear = deep\n' >bad.ini
expect "a scene that is wrong, by its line" 3 "^bad.ini:2: " bake bad.ini -o a.c
printf '[boat]\nmesh = no.obj\n' >boat.ini
expect "a mesh that is not there, by its line" 3 "^boat.ini:2: boat.mesh: no.obj" \
    bake boat.ini -o a.c
printf '[pool]\ncols = 32\ncourant = 0.6\n' >fast.ini
expect "a world that cannot be made, by its line" 3 "^fast.ini:3: pool.courant of 0.600" \
    bake fast.ini -o a.c
expect "a folder that is not there" 3 "^no/a.c: No such file" bake minimal -o no/a.c
expect "a full device" 3 "^/dev/full: No space" bake minimal -o /dev/full
timeout 60 "$program" bake minimal -o - >/dev/full 2>err
code=$?
judge "a full standard output" 3 "^standard output: No space"
(ulimit -f 1; timeout 60 "$program" bake minimal -o a.c 2>err)
code=$?
judge "a file beyond the size limit" 3 "^a.c: File too large"
absent "what was refused leaves nothing"

# -- written files --------------------------------------------------------------------

run bake minimal -o a.c
run bake minimal -o -
same "standard output gets the same" "$code $(cmp out a.c)" "0 "
same "names begin with the scene's" \
    "$(grep -c '^const tp_\(scene minimal_scene\|assets minimal_assets\) = {$' a.c)" 2
run bake count-64 -o b.c --texels 8
same "a dash in the scene's is no name" \
    "$(grep -c '^const tp_scene count_64_scene' b.c)" 1
printf '[scene]\ntitle = a?\?/ */ "b" \\\n' >'3 *.ini'
run bake '3 *.ini' -o c.c --set scene.description='/* %s */'
same "a digit is no beginning" "$code $(grep -c '^const tp_scene scene_3___scene' c.c)" \
    "0 1"
run bake harbour -o d.c --texels 32
same "no picture has more texels than allowed" \
    "$(grep -c ', 32 x 32$' d.c) $(grep -c ', 64 x 64$' d.c)" "10 0"
sum=$(awk '/^ \* +[0-9]+  together/ { print sum - $2 }
           /^ \* +[0-9]+  / { sum += $2 }' d.c)
same "the head's bytes add up" "$sum" 0
run bake three-swells -o e.c --texels 4
same "a picture named twice is written once" \
    "$(grep -c 'layer\[[02]\] = &three_swells_layer0,' e.c)" 2
run bake minimal -o f.c --set camera.y=2
same "settings are baked" "$(grep -c '^    .camera.y = 131072,$' f.c)" 1

# -- compiled code --------------------------------------------------------------------

strict="-std=c11 -Wall -Wextra -Wpedantic -Wconversion -Werror -I$root/include"
compilers=
for compiler in gcc clang; do
    command -v $compiler >/dev/null && compilers="$compilers $compiler" ||
        skip "baked scenes by $compiler" "$compiler"
done
for scene in "$root"/assets/scenes/*.ini; do
    name=$(basename "$scene" .ini)
    run bake "$scene" --texels 32 -o "$name.c"
    same "$name is baked" "$code" 0
    for compiler in $compilers; do
        # shellcheck disable=SC2086
        $compiler $strict -fsyntax-only "$name.c" 2>err
        same "$name compiles without a warning by $compiler" "$? $(head -n 3 err)" "0 "
    done
done
for compiler in $compilers; do
    # shellcheck disable=SC2086
    $compiler $strict -c c.c -o c.o 2>err
    same "so do odd names by $compiler" "$? $(head -n 3 err)" "0 "
done

run bake count-64 -o g.c --set quality.shading=quick --texels 8
same "pictures are baked as the quick rung wants them, and not beside" \
    "$(grep -c '\.baked_layer\[0\] = \|\.baked_slope = ' g.c) $(grep -c '\.layer\[0\] = &' g.c)" \
    "2 0"
run bake count-64 -o g.c --texels 8 --set quality.shading=quick --set water.clarity=3
same "but beside what exact stages will ask for" \
    "$(grep -c '\.baked_layer\[0\] = &\|\.layer\[0\] = &' g.c)" 2

# -- the module list of a program ------------------------------------------------------

run bake minimal -o h.c --size 64x48 --no-input --name baked
same "a list is told of in the head" "$code $(grep -c '^ \* *stage  sky plain' h.c)" "0 1"
run bake minimal -o i.c --size 64x48 --no-input --name baked
same "it is the same each time" "$(cmp h.c i.c)" ""
for byte in 85 170; do          # glibc fills new memory with it
    export MALLOC_PERTURB_=$byte
    run bake count-100 -o $byte.c --size 64x48 --no-input --texels 8 --name baked
done
unset MALLOC_PERTURB_
same "whatever memory held before" "$(cmp 85.c 170.c) $(grep -c 'TABLE_rows' 85.c)" " 1"
run bake deep-sea -o i.c --size 64x48 --no-input --texels 8 --set quality.shading=quick
same "a layer that an exposure's meter reads stays beside its baked one" \
    "$(grep -c '\.baked_layer\[0\] = &\|\.layer\[0\] = &' i.c)" 2
run bake minimal -o i.c --size 64x48 --no-input --without haze
same "what is left out is told" "$code $(grep -c 'uses it: .* haze$' err)" "0 1"
run bake minimal -o i.c --size 64x48 --no-input --without foam
same "unless nobody asks for it" "$code $(grep -c 'uses it' err)" "0 0"
same "RAM and flash are told, the sums of the head" \
    "$(sed 's/.*: \([0-9]*\) bytes of RAM, \([0-9]*\) of flash.*/\1 \2/' err)" \
    "$(awk '$2 == "RAM" || $2 == "flash" { print $NF }' i.c | paste -sd ' ' -)"
draws()         # PART FILE.c: how often the list names a part of drawing
{
    grep -c "^        \.$1 = &tp_draw_$1,$" "$2"
}
for options in "count-64 --no-input" "count-64" "lava --no-input"; do
    # shellcheck disable=SC2086
    run bake $options -o i.c --size 320x240 --texels 8
    draws exact_triangles i.c
done >triangles
same "triangles are left out where no row is cut, from no camera" \
    "$(paste -sd ' ' triangles)" "0 1 1"
run bake count-64 -o i.c --size 320x240 --no-input --texels 8 --kept 2k
same "lines are kept by a program that streams" \
    "$(draws kept_lines i.c) $(grep -o '\.kept_bytes = 2048' i.c | wc -l)" "1 2"
run bake minimal -o i.c --size 320x240 --no-input --texels 8 --kept 2k
same "and take nothing of one without lines" \
    "$(draws kept_lines i.c) $(grep -o ', \.kept_bytes = 0,' i.c | wc -l)" "0 1"
run bake minimal -o i.c --format i1 --no-input --with foam
same "a scene that may change is checked, and has room for its waves" \
    "$(grep -c 'check = tp_scene_check\|swells = &tp_water_swells' i.c)" 2
same "what may be switched on is in the list" \
    "$(grep -c '^    { &tp_foam_module, &tp_foam_drawing' i.c) \
$(grep -c '    \.format = TP_FORMAT_I1, .program = ' i.c)" "1 1"
for compiler in $compilers; do
    # shellcheck disable=SC2086
    $compiler $strict -c h.c -o h.o 2>err && $compiler $strict -c i.c -o i.o 2>>err
    same "lists compile without a warning by $compiler" "$? $(head -n 3 err)" "0 "
done

# -- parts missing in a list -----------------------------------------------------------

same "a scene that does not change is refused nothing" "$(grep -c lacks h.c)" 0
same "one that may is refused what its list lacks, but not what was left out" \
    "$(run bake minimal -o j.c --size 64x48 --no-input --with foam --without spray
       grep -c '^    { "boat", tp_boat_enabled, [0-9]* },$\|^    .lacks = minimal_lacks,$' j.c
       grep -c 'tp_\(spray\|foam\)_enabled' j.c)" "2
0"
run bake minimal -o k.c --size 64x48 --no-input --with foam --name baked
linked="-std=c11 -O1 -ffunction-sections -fdata-sections -Wl,--gc-sections -I$root/include \
    -I$root/src"
link()          # FILE.c PROGRAM
{
    # shellcheck disable=SC2086
    ${CC:-cc} $linked "$root/tests/host/lacks.c" "$1" "$root/build/host/libtidepool.a" \
        -o "$2" 2>err
}
link k.c lacks
same "the scene as it is and as --with has it is taken, any other refused by name" \
    "$(./lacks)" "as it is: ok
foam: ok
boat: the program lacks boat
boat without its mesh: the program lacks hull
night: the program lacks sky_dome
clear water: the program lacks clear_water"
symbols() { nm "$1" | sed -n 's/.* [TtRrDd] \(tp_[a-z_]*\)$/\1/p' | sort; }
sed '/^    .refuse = /d; /^    .lacks = /d' k.c >l.c
link l.c blind
same "to know what it lacks a program links conditions and no more" \
    "$(symbols lacks >with; symbols blind | comm -13 - with |
       grep -v '^tp_\([a-z_]*_enabled\|has_[a-z]*\|lacks_check\)$' | tr '\n' ' ')" ""
same "it has the modules of its list and no other" \
    "$(symbols lacks | sed -n '/^tp_frame_/!s/_module$//p')" \
    "$(sed -n 's/^    { &\(tp_[a-z_]*\)_module, .*/\1/p' k.c | sort)"

# A baked frame has the bits, the memory and the errors of tp_frame_init, without its code.
frames()        # SCENE [OPTION]...
{
    run bake "$@" -o m.c --name baked --size 64x48 --format rgb565 --texels 8 --no-input
    for kind in BAKED GENERAL; do
        # shellcheck disable=SC2086
        ${CC:-cc} $linked -D$kind -I"$root/ports" "$root/tests/host/baked_frame.c" m.c \
            "$root/build/host/libtidepool.a" -o $kind 2>err && ./$kind >$kind.out
    done
    same "$1 draws by its baked frame as by tp_frame_init" \
        "$(grep -c '^[0-9a-f]\{8\}$' BAKED.out) $(cmp BAKED.out GENERAL.out)" "2 "
}
frames minimal
frames harbour
frames storm --step 6
frames tank --set quality.visibility=triangles
same "a baked frame links nothing that finds it" \
    "$(symbols GENERAL | grep -c '^tp_\(frame_init\|frame_find\)$') \
$(symbols BAKED | grep '^tp_\(frame_init\|frame_find\)$')" "2 "
sed 's/\.enabled = 0x[0-9a-f]*/.enabled = 0/; s/\.laid = 0x[0-9a-f]*/.laid = 0/' m.c >n.c
# shellcheck disable=SC2086
${CC:-cc} $linked -I"$root/ports" "$root/tests/host/baked_frame.c" n.c \
    "$root/build/host/libtidepool.a" -o other 2>err && ./other >other.out
same "one of other numbers is found" "$(cmp -s other.out GENERAL.out; echo $?)" 1

# Frames from constants equal frames from files, with smaller pictures and settings too.
draws()         # SCENE [SETTING]
{
    change="--texels 16 --set camera.y=6 ${2:+--set $2}"
    # shellcheck disable=SC2086
    {
    run bake $1 -o small.c --name baked $change
    ${CC:-cc} $strict -I"$root/src" -I"$root" -I"$root/ports" "$root/tests/cross/frames.c" small.c \
        "$root/build/host/libtidepool.a" -o frames 2>err
    ./frames 64x48 0:1 xrgb8888 0x0 >drawn 2>/dev/null
    run render $1 --rung named --size 64x48 --frames 0:1 --hash $change
    }
    same "$1 draws the same from constants${2:+ with $2}" \
        "$(grep -c crc32 drawn) $(cat drawn)" "2 $(cat out)"
}
draws three-swells
draws harbour
draws count-64 quality.shading=quick
draws three-swells quality.shading=quick

finish
