#!/bin/sh
# SPDX-License-Identifier: MIT
# The host library as installed by make and used by another project: it draws the same
# picture as the program, reports errors with file and line, leaks nothing, and exports no
# names but its own.
#     library.sh PROGRAM
root=$PWD
kept=${TP_BUILD:-build/host}
. "$(dirname "$0")/../lib/script.sh"
program_begin "$1"
scenes=$root/assets/scenes
cc=${CC:-cc}
unset MAKEFLAGS MAKELEVEL MFLAGS
lacks pkg-config pkg-config "the host library" && { finish; exit; }

make --no-print-directory -s -C "$root" BUILD="$kept" DESTDIR="$work" PREFIX=/at install \
    >err 2>&1
same "make install" "$?" 0
PKG_CONFIG_PATH=$work/at/lib/pkgconfig
export PKG_CONFIG_PATH

# built NAME SOURCE [FLAG]...: compiles; memory calls are watched, in the library too.
built() {
    name=$1 source=$2
    shift 2
    $cc -std=c11 $strict -g "$@" "$source" $(pkg-config --cflags --libs tidepool-host) \
        -o "$name" 2>err
    same "$name is built by pkg-config alone" "$?" 0
}
built viewer "$root/ports/examples/viewer/viewer.c" -fsanitize=address
built use "$root/tests/host/library_use.c" -fsanitize=address -D_POSIX_C_SOURCE=200809L
[ "$failed" -eq 0 ] || { finish; exit 1; }
same "the viewer has at most 60 lines" \
    "$(wc -l <"$root/ports/examples/viewer/viewer.c" | awk '$1 > 60')" ""

# use CASE SCENE ARGUMENT: prints the case's output, and leaks or worse.
use() { timeout 120 ./use "$@" 2>&1; }
# drawn SCENE LAST [OPTION]...: prints the program's frames.
drawn() {
    of=$1 last=$2; shift 2
    timeout 120 "$program" render "$of" --size 160x120 --frames "$last" --hash "$@" 2>&1
}

# -- pictures ------------------------------------------------------------------------------

for scene in three-swells harbour tank; do
    file=$scenes/$scene.ini
    wanted=$(drawn "$file" 0:6)
    same "$scene: seven pictures are the program's" "$(use frames "$file" 6)" "$wanted"
    same "$scene: an engine, which has no plan, draws the rungs that it names" \
        "$(use engine "$file" 6)" "$(drawn "$file" 0:6 --rung named)"
done

use looks "$scenes/three-swells.ini" - >looks
same "there are four ways to look" "$(head -n 4 looks | cut -d' ' -f1 | paste -sd' ')" \
    "boat top orbit free"
same "each turns, to a picture that no other has" \
    "$(head -n 4 looks | awk '$2 != $3 { print $3 }' | grep -x '[0-9a-f]*' | sort -u | wc -l)" 4
same "the camera is there at once" "$(awk -v last="$(drawn "$scenes/three-swells.ini" 1 |
    cut -d' ' -f4)" 'NR <= 4 && $1 != "orbit" && $2 != last { at_once++ }
        { last = $3 } END { print at_once }' looks)" 3
same "free again the camera is where it was" "$(sed -n 5p looks)" "the eye is back"
same "there is no fifth" "$(tail -n 1 looks)" "no way 0: tp_host_look: no such camera mode"
same "without a boat nobody stands on it" \
    "$(use looks "$scenes/pond.ini" - | grep boat)" \
    "boat: tp_host_look: the scene has no boat"
same "what is gone round stays in the middle" "$(use orbit "$scenes/harbour.ini" -)" \
    "stays, the eye goes round"
same "64 pokes wait in a pool; pokes and stirs move it" \
    "$(use pokes "$scenes/pond.ini" "$scenes/pond.ini")" "64 pokes: moved, 1 stirs: moved"
same "where there is none nothing takes them" \
    "$(use pokes "$scenes/flat-calm.ini" "$scenes/flat-calm.ini")" \
    "0 pokes: still, 0 stirs: still"
printf '[field]\ncols = 32\nrows = 32\n' >field.ini
same "a field takes none yet" "$(use pokes field.ini field.ini)" \
    "0 pokes: still, 0 stirs: still"
same "two scenes do not disturb each other, by two threads either" \
    "$(use two "$scenes/three-swells.ini" "$scenes/pond.ini")" "the same, two scenes"

# -- values --------------------------------------------------------------------------------

cat >sea.ini <<'END'
[wave0]
amplitude = 0.5
[layer0]
texture = blue.png
END
cp "$root"/assets/textures/*.png . && cp "$(ls ./*.png | head -n 1)" blue.png
cp "$(ls ./*.png | tail -n 1)" other.png
listed="4 layer0.texture = blue.png
2 wave0.amplitude = 0.5"
same "what the file sets is listed with its lines" "$(use values sea.ini wave0.amplitude)" \
    "$listed
it is 0.5, line 2"
same "a default has no line" "$(use values sea.ini wave1.amplitude | tail -n 1)" \
    "it is $("$program" params --only wave1.amplitude 2>/dev/null |
        awk '$1 == "wave1.amplitude" { print $2 }'), line 0"
same "a name is known or not" "$(use values sea.ini wave0.high | tail -n 1)" \
    "wave0.high is none"
same "a value that is set shows" "$(use set sea.ini wave0.amplitude=0.9)" \
    "set, another picture: $(
    )
4 layer0.texture = blue.png
0 hand wave0.amplitude = 0.9"
same "so does a picture" "$(use set sea.ini layer0.texture=other.png | sed 1q)" \
    "set, another picture: "
same "what makes the world anew too" "$(use set sea.ini grid.vertices=700 | sed 1q)" \
    "set, another picture: "
same "what is out of range is refused, and nothing changes" \
    "$(use set sea.ini wave0.amplitude=900)" \
    "refused, the same picture: tp_host_set: wave0.amplitude = 900 is outside 0..16 m
$listed"
same "so is a picture that is not there" "$(use set sea.ini layer0.texture=no.png)" \
    "refused, the same picture: tp_host_set: layer0.texture: no.png: No such file or directory
$listed"
same "a name that is none is told with the nearest" \
    "$(use set sea.ini wave0.amplitud=1 | sed 1q)" "refused, the same picture:$(
    ) tp_host_set: no parameter is called wave0.amplitud; did you mean wave0.amplitude?"

cat sea.ini - >slow.ini <<'END'
[clock]
scale = 0.3
END
same "slow motion is the program's" "$(use frames slow.ini 9)" "$(drawn slow.ini 0:9)"
same "there pictures move between ticks too" \
    "$(use frames slow.ini 9 | cut -d' ' -f4 | sort -u | wc -l)" 10
same "and the camera by each input" "$(use turns slow.ini 10)" 10
printf '[clock]\nscale = 3\n' >quick.ini
same "as where a picture has three ticks" "$(use turns quick.ini 10)" 10
for word in none boat; do
    same "camera.follow = $word holds where the camera is free, and not on the deck" \
        "$(use follow "$scenes/three-swells.ini" $word)" "1 the same, free: $word"
done

# -- errors --------------------------------------------------------------------------------

# refuses NAME SCENE MESSAGE
refuses() {
    same "$1" "$(use values "$2" - 2>&1)" "refused: $3"
}
refuses "a scene that is missing" no.ini "no.ini: No such file or directory"
refuses "a plain word is a path, and no shipped scene" harbour \
    "./harbour: No such file or directory"
refuses "no name at all" "" "./: Is a directory"
same "a size that no picture has" "$(use sized sea.ini 5)" \
    "refused: tp_host_open: picture of 5 x 120 pixels; 16 x 16 to 4096 x 4096 can be drawn"
same "one that it has" "$(use sized sea.ini 16)" "opened: "
printf '[wave%s]\namplitude = 0.5\nsteepness = 0.9\n' 0 1 >steep.ini
run render steep.ini --frames 1 --hash
same "warnings are no failure" "$(use sized steep.ini 16)" \
    "opened: steep: steepness sum 1.8 is clamped to 0.95"
same "the program has the same ones" "$(cat err)" "steep: steepness sum 1.8 is clamped to 0.95"
printf '[wave0]\n\namplitude = high\n' >bad.ini
use values bad.ini - >out
same "a bad value is told with file and line" "$(grep -c '^refused: bad.ini:3: wave0' out)" 1
printf '[boat]\nscale = 1\nmesh = no.obj\n' >bad.ini
refuses "a file that a scene names" bad.ini \
    "bad.ini:3: boat.mesh: no.obj: No such file or directory"
printf '[layer0]\ntexture = bad.png\n' >bad.ini
echo 'this is no picture' >bad.png
use values bad.ini - >out
same "a picture that is none" "$(grep -c '^refused: bad.ini:2: layer0.texture: bad.png: ' out)" 1
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n' >bad.obj
printf '[boat]\nmesh = bad.obj\n' >bad.ini
use values bad.ini - >out
same "a mesh that is broken, by its own line" "$(grep -c '^refused: bad.obj:4: ' out)" 1
same "a picture that cannot be written" "$(use save sea.ini no/such.png)" \
    "0: no/such.png: No such file or directory"
echo old >sea.png
chmod 640 sea.png
same "one that can" "$(use save sea.ini sea.png)" "1: "
"$program" render sea.ini --size 160x120 --frames 1 --out one.png >out 2>&1
same "is the program's, byte for byte" "$(cmp sea.png one.png 2>&1)" ""
same "with the old one's rights, and nothing beside it" \
    "$(stat -c %a sea.png) $(ls | grep -c '^sea\.png')" "640 1"

# -- the viewer ----------------------------------------------------------------------------

timeout 60 ./viewer "$scenes/harbour.ini" 0 still.png >out 2>err
same "the viewer ends well" "$? $(cat err)" "0 "
same "it picks water in the middle" "$(grep -c '^in the middle: water at ' out)" 1
"$program" render "$scenes/harbour.ini" --size 320x240 --frames 1 --out h.png >out 2>&1
same "its picture is the program's" "$(cmp still.png h.png 2>&1)" ""
timeout 60 ./viewer "$scenes/harbour.ini" 40 round.png >out 2>err
same "gone round it is another" "$? $(cmp -s still.png round.png; echo $?)" "0 1"
timeout 60 ./viewer no.ini 0 none.png >out 2>err
same "and it tells of a missing scene" "$? $(cat err)" "1 no.ini: No such file or directory"

# -- names ---------------------------------------------------------------------------------

library=$work/at/lib/libtidepool-host.a
same "no symbol is without the prefix" \
    "$(nm -g --defined-only "$library" | awk 'NF == 3 && $3 !~ /^tp_host_/')" ""
declared=$(grep -o 'tp_host_[a-z_]*(' "$work/at/include/tidepool/host.h" | tr -d '(' | sort -u)
same "what the header declares is there, and no more" \
    "$(nm -g --defined-only "$library" | awk 'NF == 3 { print $3 }' | sort)" "$declared"
same "it ends no program, catches no signal, prints nothing" \
    "$(nm -u "$library" | awk '{ print $2 }' | grep -xE \
        '_?exit|abort|atexit|quick_exit|signal|__sysv_signal|sigaction|stdout|printf|puts')" ""
for language in "cc -std=c11" "c++ -std=c++11"; do
    echo '#include <tidepool/host.h>' >alone.c
    same "the header is ${language%% *}'s" "$($language $strict -x "$(
        case $language in c++*) echo c++ ;; *) echo c ;; esac)" -fsyntax-only \
        -I"$work/at/include" alone.c 2>&1)" ""
done

# SDL's flags ask the C library for POSIX names; without SDL a file asks by itself.
same "nothing that it is made of needs SDL" "$(cd "$root" && for file in \
        ports/app/[cfs]*/*.c ports/tools/*/*.c ports/interact/*.c ports/library/*.c; do
    $cc -std=c11 -Iinclude -Iports -Iports/library -Isrc -I. -fsyntax-only "$file" 2>&1
done | grep error)" ""

finish
