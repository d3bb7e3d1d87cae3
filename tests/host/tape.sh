#!/bin/sh
# SPDX-License-Identifier: MIT
# Tapes: recorded inputs replay to the same frames; bad files are refused with file and
# line.
#     tape.sh PROGRAM
. "$(dirname "$0")/../lib/script.sh"
program_begin "$1"

boats=$(cd "$OLDPWD" && realpath assets/boats)

# hashes SCENE OPTION...: prints the frames' hashes, or the exit code and messages.
hashes() {
    timeout 60 "$program" render "$@" --size 48x32 --frames 40 --hash 2>err </dev/null ||
        { echo "exit $?"; cat err; }
}

# tape NAME LINE...: writes a tape of the scene `minimal`.
tape() {
    file=$1
    shift
    { echo "tape 2 minimal"; for line in "$@"; do printf '%s\n' "$line"; done; } >"$file"
}

# refused NAME PATTERN FILE: exit code 3, empty stdout, a message with this beginning.
refused() {
    run render minimal --size 48x32 --frames 40 --hash --tape "$3"
    if [ "$code" -ne 3 ]; then
        verdict "$1" "exit code $code, expected 3"
    elif [ -s out ]; then
        verdict "$1" "frames were drawn"
    elif [ "$(wc -l <err)" -ne 1 ] || ! grep -q -e "^$2" err; then
        verdict "$1" "no message like '$2'"
    else
        verdict "$1" ""
    fi
}

# bad NAME PATTERN LINE: a tape with this third line is refused with file and line.
bad() {
    tape bad.tape "3 ahead=0.5" "$3"
    refused "$1" "bad.tape:3: $2" bad.tape
}

# -- old names of parameters ---------------------------------------------------------

tape new.tape "4 set drops.count=20" "4 set drops.interval=0.1" "9 set mirror.method=cube"
tape old.tape "4 set drops.count=20" "4 set drops.every=0.1" "9 set mirror.objects=cube"
same "old names are played" "$(hashes minimal --tape old.tape)" \
    "$(hashes minimal --tape new.tape)"
hashes minimal --tape old.tape >/dev/null
same "with one warning" "$(sed 's/; .*//' err)" \
    "old.tape:3: drops.every is now called drops.interval (and 1 more old name)"

# -- replays ------------------------------------------------------------------------

plain=$(hashes minimal)
tape walk.tape "0 ahead=0.5" "# a turn" "" "3 turn=30000000 tilt=-9000000" \
    "20 aside=-1 up=0.25"
walk=$(hashes minimal --tape walk.tape)
same "a tape is played" "$(echo "$walk" | grep -c '^frame')" 40
same "a tape plays twice alike" "$(hashes minimal --tape walk.tape)" "$walk"
same "frame 0 comes before its first line" "$(echo "$walk" | head -1)" \
    "$(echo "$plain" | head -1)"
if [ "$walk" = "$plain" ]; then verdict "a tape moves the camera" "it does not"
else verdict "a tape moves the camera" ""; fi

# All pokes of a tick have an effect; their order on the line is free.
pond() { hashes pond --set pool.splash_interval=0 --tape "$1"; }
poked() { printf 'tape 2 pond\n3 %s\n' "$1" >poked.tape; pond poked.tape; }
one="poke=0.3 poke_x=-1" two="poke2=0.3 poke2_x=1" last="poke8=0.2 poke8_z=1"
all=$(poked "$one $two $last")
same "a tape of several pokes in a tick plays" "$(echo "$all" | grep -c '^frame')" 40
same "in any order" "$(poked "$last $one $two")" "$all"
for lacks in "$one $two" "$one $last" "$two $last"; do
    if [ "$(poked "$lacks")" = "$all" ]; then verdict "each acts" "not without $lacks"
    else verdict "each poke acts: others than $lacks" ""; fi
done
bad "a poke too many" "no input is called poke9" "4 poke=1 poke9=1"
bad "a poke twice" "poke2 occurs twice" "4 poke2=1 poke2=1"

tape none.tape "5" "6" "# nothing"
same "lines without inputs change nothing" "$(hashes minimal --tape none.tape)" "$plain"
tape bare.tape
same "a tape of its head alone changes nothing" "$(hashes minimal --tape bare.tape)" \
    "$plain"
tape late.tape "39 ahead=3" "18446744073709551615 ahead=1"
same "what comes after the last frame is not played" \
    "$(hashes minimal --tape late.tape)" "$plain"
tr '\n' '|' <walk.tape | sed 's/|/\r\n/g' >dos.tape
same "line ends of other systems" "$(hashes minimal --tape dos.tape)" "$walk"
printf '%s' "$(cat walk.tape)" >cut.tape
same "a last line without its end" "$(hashes minimal --tape cut.tape)" "$walk"
{ head -1 walk.tape; echo "  0	ahead=0.5  "; sed 1,2d walk.tape; } >blank.tape
same "blanks around and between" "$(hashes minimal --tape blank.tape)" "$walk"
{ head -2 walk.tape; printf '# %0900d 2 ahead=9\n' 7; sed 1,2d walk.tape; } >long.tape
same "a long comment is one comment" "$(hashes minimal --tape long.tape)" "$walk"

# Values that change the world: on a tape, and from the first tick on.
slow="--set pool.courant=0.2 --set pool.interval=2 --set foam.cells=32 --set foam.slices=4"
printf 'tape 2 pond\n3 drops=2\n9 poke=0.3\n' >slow.tape
printf 'tape 2 pond\n3 drops=2\n5 set pool.courant=0.2\n6 set pool.interval=2\n' >edit.tape
printf 'tape 2 pond\n5 set pool.interval=2\n' >fast.tape
# shellcheck disable=SC2086
{
calm=$(hashes pond --tape slow.tape $slow)
same "slow steps of a pool play" "$(echo "$calm" | sort -u -k4 | wc -l)" 40
same "and twice alike" "$(hashes pond --tape slow.tape $slow)" "$calm"
same "and with any tiling" "$(hashes pond --tape slow.tape $slow --strip 16)" "$calm"
same "from the middle too, between two steps" "$(timeout 60 "$program" render pond \
    --size 48x32 --frames 33:39 --hash --tape slow.tape $slow 2>err)" \
    "$(echo "$calm" | tail -7)"
}
edited=$(hashes pond --tape edit.tape)
same "a tape sets them while the water moves" "$(hashes pond --tape edit.tape)" "$edited"
run render pond --size 48x32 --frames 9:9 --hash --tape fast.tape
same "too long a step names its line of the tape" "$code $(grep -c \
    '^fast.tape:2: pool.interval: a step in 2 ticks takes a courant up to 0.249' err)" "3 1"

# From the stern of a steered boat: replays and tilings equal to the bit.
{ echo "tape 2 three-swells"; echo "2 throttle=6 rudder=20"; echo "9 ahead=0.5"
  echo "15 throttle=6 turn=20000000"; } >deck.tape
deck="--set camera.follow=boat --set camera.x=0 --set camera.y=2.8 --set camera.z=6"
# shellcheck disable=SC2086
{
aboard=$(hashes three-swells --tape deck.tape $deck)
same "a voyage is seen from aboard" "$(echo "$aboard" | sort -u -k4 | wc -l)" 40
same "it plays twice alike" "$(hashes three-swells --tape deck.tape $deck)" "$aboard"
for tiling in "--band 5" "--strip 16" "--threads 2 --strip 32"; do
    same "it is the same with $tiling" \
        "$(hashes three-swells --tape deck.tape $deck $tiling)" "$aboard"
done
}

part=$(timeout 60 "$program" render minimal --size 48x32 --frames 30:39 --hash \
    --tape walk.tape 2>err)
same "frames from the middle are the same" "$part" "$(echo "$walk" | tail -10)"

drops="--set drops.count=20 --set drops.interval=0 --set camera.pitch=-20"
printf 'tape 2 minimal\n1 drops=5\n9 sphere_z=-0.5 drops=3\n' >drops.tape
# shellcheck disable=SC2086
same "drops fall alike twice" "$(hashes minimal $drops --tape drops.tape)" \
    "$(hashes minimal $drops --tape drops.tape)"
tape slow.tape "2 slower=3"
slow=$(hashes minimal --tape slow.tape --set wave0.amplitude=0.5)
same "slow motion replays" "$(hashes minimal --tape slow.tape --set wave0.amplitude=0.5)" \
    "$slow"

# -- changes and looks --------------------------------------------------------------

# sea OPTION...: prints the hashes of three-swells with a tape; its lines come first.
sea_tape() {
    file=$1
    shift
    { echo "tape 2 three-swells"; for line in "$@"; do printf '%s\n' "$line"; done; } >"$file"
}

calm=$(hashes three-swells)
sea_tape set.tape "20 set wave0.amplitude=1.5"
set=$(hashes three-swells --tape set.tape)
same "a set plays twice alike" "$(hashes three-swells --tape set.tape)" "$set"
same "what comes before a set is as without" "$(echo "$set" | head -21)" \
    "$(echo "$calm" | head -21)"
same "a set changes what comes after, from the next picture on" \
    "$({ echo "$calm"; echo "$set"; } | sort | uniq -u | wc -l)" 38
sea_tape first.tape "0 set wave0.amplitude=1.5"
same "a set before the first step is as --set" \
    "$(hashes three-swells --tape first.tape | tail -39)" \
    "$(hashes three-swells --set wave0.amplitude=1.5 | tail -39)"
sea_tape there.tape "10 set wave0.amplitude=1.5" "10 set wave0.length = 20 " \
    "25 set wave0.amplitude=1" "25 set wave0.length=1e1"
back=$(hashes three-swells --tape there.tape)
for tiling in "--band 5" "--threads 2 --strip 16"; do
    # shellcheck disable=SC2086
    same "sets are the same with $tiling" \
        "$(hashes three-swells --tape there.tape $tiling)" "$back"
done
sea_tape cr.tape "20 set wave0.amplitude=1.5"
tr '\n' '|' <cr.tape | sed 's/|/\r\n/g' >dos.tape
same "sets with line ends of other systems" "$(hashes three-swells --tape dos.tape)" "$set"

# pond's water has cells: a new number of cells needs a new world; a new grid needs a new
# frame only.
printf 'tape 2 pond\n5 drops=1\n10 set pool.cols=80\n12 poke=0.3\n30 ahead=1\n' >anew.tape
anew=$(hashes pond --tape anew.tape)
same "a set makes the world anew, twice alike" "$(hashes pond --tape anew.tape)" "$anew"
same "all of it is drawn" "$(echo "$anew" | grep -c '^frame')" 40
same "the same tape in tiles" "$(hashes pond --tape anew.tape --band 7)" "$anew"
printf 'tape 2 pond\n5 set grid.vertices=1100\n6 set grid.vertices=1320\n' >grid.tape
grid=$(hashes pond --tape grid.tape)
same "a set of the grid, twice alike" "$(hashes pond --tape grid.tape)" "$grid"
same "grids are drawn" "$(echo "$grid" | sort -u -k4 | wc -l)" 40
sea_tape kinds.tape "3 set sky.kind=day" "5 set mirror.method=cube" "7 set foam.cells=64" \
    "9 set mirror.method=none" "11 set drops.count=30" "12 drops=3" "20 set boat.mesh="
kinds=$(hashes three-swells --tape kinds.tape)
same "skies, mirrors, foam, drops and no boat, twice alike" \
    "$(hashes three-swells --tape kinds.tape)" "$kinds"
same "and are drawn" "$(echo "$kinds" | sort -u -k4 | wc -l)" 40
tape mesh.tape "5 set boat.mesh=$boats/longship.obj" "30 set boat.mesh="
mesh=$(hashes minimal --tape mesh.tape)
same "a mesh comes from its file and goes" \
    "$({ echo "$plain"; echo "$mesh"; } | sort | uniq -u | wc -l)" 50

sea_tape look.tape "20 look turn=90000000 tilt=-3000000" "20 look up=2" "20 aside=1"
look=$(hashes three-swells --tape look.tape)
sea_tape looks.tape "20 look tilt=-3000000" "20 look turn=90000000" "20 look up=1" \
    "20 look up=1" "20 aside=1"
same "looks add up" "$(hashes three-swells --tape looks.tape)" "$look"
same "looks come before their tick's picture" "$(echo "$look" | head -21)" \
    "$(echo "$calm" | head -21)"
sea_tape slow.tape "3 set clock.scale=0.25" "9 set wave1.amplitude=1" "9 look turn=50000000"
slow=$(hashes three-swells --tape slow.tape)
same "sets in slow motion, twice alike" "$(hashes three-swells --tape slow.tape)" "$slow"
same "fast: a change inside a picture" \
    "$(sea_tape fast.tape "3 look turn=90000000"; \
       hashes three-swells --set clock.scale=2 --tape fast.tape | sort -u -k4 | wc -l)" 40

# -- bad files ----------------------------------------------------------------------

refused "no such tape" "no.tape: No such file" no.tape
mkdir folder.tape
refused "a folder" "folder.tape: " folder.tape
: >empty.tape
refused "an empty file" "empty.tape: empty; expected \"tape 2 SCENE\"" empty.tape
for head in "tap 2 minimal" "tape 2" "" "5 ahead=1" "# tape 2 minimal"; do
    printf '%s\n5 ahead=1\n' "$head" >head.tape
    refused "head '$head'" "head.tape:1: expected \"tape 2 SCENE\", found" head.tape
done
for format in 1 3; do
    printf 'tape %s minimal\n5 ahead=1\n' $format >head.tape
    refused "a tape of format $format" "head.tape:1: a tape of format $format; " head.tape
done
printf 'tape 2 three-swells\n5 ahead=1\n' >other.tape
refused "another scene's tape" "other.tape:1: .*three-swells.*minimal" other.tape
printf 'tape 2 %0400d\n' 1 >head.tape
refused "a head that is too long" "head.tape:1: longer than" head.tape
printf 'tape 2 %0200d\n' 1 >head.tape
refused "a name that is too long" "head.tape:1: longer than" head.tape

bad "no tick" "expected a tick, found ahead=1" "ahead=1"
bad "a negative tick" "expected a tick, found -4" "-4 ahead=1"
bad "a tick with a fraction" "expected a tick, found 4.5" "4.5 ahead=1"
bad "a tick beyond all" "99999999999999999999 is outside its range" \
    "99999999999999999999 ahead=1"
bad "a name alone" "expected NAME=NUMBER, found ahead" "4 ahead"
bad "a number alone" "expected NAME=NUMBER, found =1" "4 =1"
bad "an unknown name" "no input is called sideways" "4 sideways=1"
bad "a name twice" "ahead occurs twice" "4 ahead=1 ahead=1"
bad "no number" "expected a number" "4 ahead="
bad "a bad number" "expected a number, found 1m" "4 ahead=1m"
bad "a fraction of what is whole" "expected a number, found 1.5" "4 drops=1.5"
bad "a number beyond its type" "ahead=40000 is outside" "4 ahead=40000"
bad "more drops than can be" "drops=1025 is outside" "4 drops=1025"
bad "fewer drops than none" "drops=-1 is outside" "4 drops=-1"
bad "the same tick again" "ticks must increase" "3 ahead=1"
bad "an earlier tick" "ticks must increase" "2 ahead=1"
bad "an earlier tick without input" "ticks must increase" "0"
bad "a line that is too long" "longer than" "4 ahead=1$(printf '%01100d' 0)"
bad "a line that is too long but for a good beginning" "longer than" \
    "4 ahead=1$(printf '%1100s' '')5 ahead=1"
printf 'tape 2 minimal\n3 ahead=1\n4 ahead=1\000 aside=2\n' >bad.tape
refused "a zero byte in a line" "bad.tape:3: " bad.tape

bad "a set of nothing" "expected NAME=VALUE, found nothing" "4 set"
bad "a set without a value" "expected NAME=VALUE, found camera.x" "4 set camera.x"
bad "a set without a name" "expected NAME=VALUE, found =4" "4 set =4"
bad "a set of what is none" "no parameter is called wave0.amplitud; did you mean" \
    "4 set wave0.amplitud=1"
bad "a set beyond its range" "wave0.amplitude = 99 is outside 0..16 m" \
    "4 set wave0.amplitude=99"
bad "a set of no number" "wave0.amplitude: expected a number, found high" \
    "4 set wave0.amplitude=high"
bad "a set of no choice" "sky.kind = dawn is none of " "4 set sky.kind=dawn"
bad "a set of a file that is not there" "boat.mesh: no.obj: No such file" \
    "4 set boat.mesh=no.obj"
bad "a set of a file that is no picture" "layer0.texture: bad.tape: not a PNG" \
    "4 set layer0.texture=bad.tape"
bad "a sky of pictures that are not named" "sky.kind: a cube needs six pictures" \
    "4 set sky.kind=cube"
bad "a set at no tick" "expected a tick, found set" "set camera.x=4"
bad "a set at an earlier tick" "ticks must increase" "2 set camera.x=4"
bad "a set after its tick's input" \
    "expected look and set lines before the input of their tick" \
    "3 set camera.x=4"
bad "a look after its tick's input" "expected look and set lines before" "3 look turn=4"
bad "a look that lets drops fall" "a look only moves the camera" "4 look turn=4 drops=1"
bad "a look with an unknown name" "no input is called sideways" "4 look sideways=1"
bad "a word that is neither" "expected NAME=NUMBER, found looks" "4 looks turn=1"
tape twice.tape "4 set pool.cols=64" "4 set pool.drive_min=0.5" "4 set pool.drive_max=1"
run render minimal --size 48x32 --frames 40 --hash --tape twice.tape
same "of one tick sets are taken in any order" "$code $(wc -l <out)" "0 40"
tape bad.tape "4 set pool.cols=64" "4 set pool.damping=10" "4 set pool.courant=0.8"
refused "a pool that would not come to rest" "bad.tape:4: pool.courant of 0.800 is above" \
    bad.tape
printf 'tape 2 minimal\n4 set camera.x=4\000\n' >bad.tape
refused "a zero byte in a set" "bad.tape:2: " bad.tape

expect "--tape without a file" 2 "--tape needs a value" render minimal --tape

finish
