#!/bin/sh
# SPDX-License-Identifier: MIT
# The program with good and bad command lines and files: exit codes, messages, outputs.
#     cli.sh PROGRAM
. "$(dirname "$0")/../lib/script.sh"
program_begin "$1"

# absent NAME PATTERN: expects no file with such a name.
absent() {
    if ls -A . | grep -q -e "$2"; then
        verdict "$1" "left behind: $(ls -A . | grep -e "$2" | tr '\n' ' ')"
    else
        verdict "$1" ""
    fi
}

# -- help and usage -----------------------------------------------------------------

fits --help
unseen=$("$program" view --help 2>&1 >out | grep "built without")
[ -n "$unseen" ] || fits view --help
for command in render show scenes params bake plan check bench charts join manual \
        completion help version; do
    fits "$command" --help
    mv out wanted
    run help "$command"
    same "help $command says the same" "$code $(cmp out wanted)" "0 "
    run "$command" -h
    same "$command -h too" "$code $(cmp out wanted)" "0 "
done
run --help
mv out wanted
for word in help -h; do
    run $word
    same "$word lists the commands, as --help does" "$code $(cmp out wanted)" "0 "
done
expect "help of no command" 2 "no command rendr; did you mean render?" help rendr
expect "help of two" 2 "too many names" help render view
run --version
same "--version prints name and number" \
    "$(grep -c '^tidepool [0-9]*\.[0-9]*\.[0-9]*$' out)" 1
mv out wanted
for word in version -V; do
    run $word
    same "$word prints the same" "$code $(cmp out wanted)" "0 "
done
expect "a version of something" 2 "too many names" version render

expect "no command" 2 "COMMAND is missing"
expect "a command of no letters" 2 "COMMAND is missing" ""
expect "an option for a command" 2 "no option -x; it takes --help" -x
for scene in storm my.ini ./sub/my.ini; do
    expect "a scene for a command: $scene" 2 \
        "no command $scene; did you mean .tidepool view $scene" "$scene"
done
expect "a long name" 2 "no command a*; see" "$(printf 'a%.0s' $(seq 5000))"
expect "unknown command" 2 "no command rendr; did you mean render?" rendr
expect "unknown option" 2 "no option --siez; did you mean --size?" render three-swells \
    --siez 64x48
expect "an option like no other" 2 "no option --bogus; see" render three-swells --bogus
for command in render params plan join completion; do
    expect "$command of an empty name" 2 "$command: a name is empty; see" $command ""
done
expect "a name for what takes none" 2 "too many names: storm; see" scenes storm
expect "names behind --" 2 "too many names: --hash; see" render -- minimal --hash
expect "option without its value" 2 "needs a value" render three-swells --size
expect "switch with a value" 2 "no option --hash=1" render three-swells --hash=1
expect "an empty value" 2 "render: --size '': expected WIDTHx" render minimal --size ""
expect "an empty setting" 2 "^tidepool: --set '': expected name=value" render minimal --set ""
expect "no scene" 2 "SCENE is missing" render
expect "two scenes" 2 "too many names" render three-swells minimal
expect "kept lines of no bytes" 2 "bytes, 1..16M" render minimal --kept 0
expect "too many kept bytes" 2 "bytes, 1..16M" plan minimal --kept 17M
for size in 0x0 15x16 16x4097 640 640x480x3 -1x16 64x 99999999999999999999x16 64X48; do
    expect "size $size" 2 "expected WIDTHxHEIGHT" render minimal --size "$size"
done
for frames in 0 -1 5:3 :3 3: a 1:2:3; do
    expect "frames $frames" 2 "expected a count" render minimal --frames "$frames"
done
expect "strip of 24 columns" 2 "multiple of 16" render minimal --strip 24
expect "no threads" 2 "1..64" render minimal --threads 0
for memory in 0 -1 5x 1kk k 99999999999; do
    expect "memory of $memory" 2 "expected bytes" render minimal --memory $memory
done
if [ -z "$unseen" ]; then
for scale in 0 17 2x -1; do
    expect "pixels $scale times as large" 2 "expected 1..16" view --scale $scale
done
for size in 49 401 150% large; do
    expect "letters of $size" 2 "expected percent, 50..400" view --ui $size
done
for frames in 0 2:5 x; do
    expect "a preview of $frames frames" 2 "expected a count from 1" view --frames $frames
done
expect "playing and recording" 2 "exclude" view --play a.tape --tape b.tape
expect "playing and resuming" 2 "exclude" view --play a.tape --resume
expect "a tape of no name" 2 "expected a file name" view --play=
expect "keys of no name" 2 "expected a file name" view --keys=
expect "two scenes to view" 2 "too many names" view pond tank
fi
expect "--scale is the preview's" 2 "no option --scale" render minimal --scale 2
expect "rungs and peers together" 2 "exclude" bench --rungs --peers
expect "a bench of a range" 2 "expected a count from 1" bench --frames 1:2
expect "a bench of no points" 2 "expected 2..1024" bench --points 1
expect "a bench of unknown work" 2 "plain, full or smooth" bench --work water
expect "peers outside of the project" 3 "project's folder" bench --peers
run bench --size 64x48 --points 16 --frames 2 --csv
same "a bench as CSV: a line of names and three of figures" "$(wc -l <out)" 4
expect "unknown format" 2 "rgb565be" render minimal --format rgb555
expect "visibility of no kind" 2 "auto, triangles" render minimal --visibility cubes
expect "output of unknown kind" 2 "ends in .png, .apng or .y4m" render minimal --out picture.jpg
expect "several frames, one name" 2 "need a number" render minimal --frames 2 --out f.png
expect "a % that is no number" 2 "%04d" render minimal --out f-%s.png

# -- films in parts -----------------------------------------------------------------

for range in 0:6 0:2 3:3 4:6; do
    run render storm --size 33x17 --frames $range --out "$range.y4m"
done
same "parts are drawn" "$(ls ?:?.y4m | wc -l)" 4
expect "parts are joined" 0 "" join all.y4m 0:2.y4m 3:3.y4m 4:6.y4m
verdict "to the film of one run" "$(cmp all.y4m 0:6.y4m 2>&1)"
run join - 0:2.y4m 3:3.y4m 4:6.y4m
verdict "and by standard output" "$(cmp out 0:6.y4m 2>&1)"
expect "a film may be a part of itself" 0 "" join 0:2.y4m 0:2.y4m 3:3.y4m
run join 0:2.y4m 0:2.y4m 4:6.y4m
verdict "which it then is" "$(cmp 0:2.y4m 0:6.y4m 2>&1)"
rm all.y4m
run render storm --size 32x17 --frames 1 --out other.y4m
head -c -1 3:3.y4m >cut.y4m
head -c 200 3:3.y4m >half.y4m
head -n 1 3:3.y4m >empty.y4m
{ cat 3:3.y4m; echo WHAT; } >more.y4m
sed '1s/C420jpeg/C444/' 3:3.y4m >full.y4m
: >nothing.y4m
refused() {     # NAME PATTERN PART...
    expect "$1" 3 "$2" join all.y4m 0:6.y4m $3
    verdict "$1: no film" "$(ls -A | grep -e '^all' -e tidepool-)"
}
refused "a part of another size" \
    "^other.y4m: its head differs from that of 0:6.y4m: W32 H17 .*; W33 H17" other.y4m
refused "a part cut off" "^cut.y4m: ends inside of frame 0$" cut.y4m
refused "in its first row" "^half.y4m: ends inside of frame 0$" half.y4m
refused "a part without frames" "^empty.y4m: a film without frames$" empty.y4m
refused "a part with more behind" "^more.y4m: expected the head of frame 1" more.y4m
refused "a part of no bytes" "^nothing.y4m: not a YUV4MPEG2 film$" nothing.y4m
echo "; a scene" >a.ini
refused "a part that is no film" "^a.ini: not a YUV4MPEG2 film$" a.ini
refused "a part that is not there" "^nowhere.y4m: No such file" nowhere.y4m
refused "a folder" "^\.: Is a directory$" .
expect "a film of another kind" 3 "full.y4m: not a 4:2:0 film" join all.y4m full.y4m
expect "no parts" 2 "needs FILM.y4m and PART.y4m" join all.y4m
expect "a name that is no film's" 2 "a film's name ends in .y4m" join all.mp4 0:6.y4m
rm -f ./*.y4m

# -- scenes -------------------------------------------------------------------------

expect "scene that does not exist" 3 "no such scene or file; did you mean three-swells?" render \
    three-swels
expect "scene like no other" 3 "tidepool scenes" render qqqqqqqq
expect "scene file that does not exist" 3 "nowhere.ini: No such file" render nowhere.ini
mkdir folder.ini folder
expect "a folder without that" 3 "^folder: Is a directory$" render folder
echo "; a scene" >-d.ini
expect "a scene file that begins with a dash" 0 "" render --size 16x16 --hash -- -d.ini
rm -- -d.ini
rmdir folder
expect "folder for a scene" 3 "folder.ini: Is a directory" render folder.ini
run scenes
same "scenes lists three-swells and what it shows" \
    "$code $(grep -c '^three-swells  *A longship' out)" "0 1"
same "every scene tells what it shows, in a line of the screen" \
    "$(awk 'NF < 4 || length($0) > 80' out)" ""
run params --only wave1.
same "params --only lists a group alone" \
    "$code $(grep -c '^wave1\.' out) $(wc -l <out)" "0 7 9"
expect "--only of nothing" 2 "no name begins with wive" \
    params --only wive
"$program" params 2>err | head -1 >out
same "params goes on into head without a word" "$(wc -l <out) $(wc -c <err)" "1 0"
run params
same "params lists wave0.steepness" "$code $(grep -c '^wave0.steepness .*0\.\.1 ' out)" \
    "0 1"
run params minimal --set wave0.steepness=0.25
same "params shows a scene's values" "$code $(grep -c '^wave0.steepness *0.25 ' out)" \
    "0 1"

# -- the plan -----------------------------------------------------------------------

for scene in count-64 three-swells pond harbour; do
    fits plan $scene --size 320x240
done
fits plan three-swells --size 4096x4096 --set water.specular=4
expect "plan of no scene" 2 "SCENE is missing" plan
expect "plan of an unknown scene" 3 "did you mean three-swells?" plan three-swels
run plan minimal --csv
same "a plan as a table: a line each kind, the head, exact and total" \
    "$code $(wc -l <out) $(awk -F, 'NF != 5' out | wc -l)" "0 42 0"
cp out table
run plan minimal --csv
same "the same plan again" "$(cat out)" "$(cat table)"
run plan minimal --csv --set quality.shading=quick
same "what the scene names is taken" \
    "$(grep -c '^quality.shading,quick,named,' out)" 1
run plan minimal --csv --visibility rows
same "and what the command line names" \
    "$(grep -c '^quality.visibility,rows,named,' out)" 1
# The plan's values of the world are settings that --set takes, at the cost that it says.
run plan pond --csv
same "a pond's ticks are in its plan" \
    "$code $(grep -c '^tick,' out) $(awk -F, 'NF != 5' out | wc -l)" "0 4 0"
awk -F, '$1 == "tick" { if (!$2) now = $4
    print $2 "," ($2 ? now - $4 : now) }' out >ticks
while IFS=, read -r settings cost; do
    set --
    for setting in $settings; do set -- "$@" --set "$setting"; done
    run plan pond --csv "$@"
    awk -F, '$1 == "tick" && $2 == "" { print $4 }' out >>again
    echo "$cost" >>said
done <ticks
same "each costs a tick what the plan says" "$(cat again)" "$(cat said)"
same "the first is the scene's own and the dearest" "$(sort -rn said | head -1)" \
    "$(head -1 said)"
# So are its values that take less RAM, which save the bytes that it says.
bytes_of() {            # [OPTION]...
    run plan harbour --size 320x240 --csv "$@"
    awk -F, '$1 == "ram" && $2 != "stack" { n += $4 } END { print n }' out
}
run plan harbour --size 320x240 --csv
grep '^less ram,' out >rams
same "a harbour's pool and mirror may be smaller" \
    "$(awk -F, '$4 > 0 && $5 > 0 && NF == 5' rams | cut -d, -f2 | paste -sd' ')" \
    "pool.cell_bits=8 mirror.colours=rgb565 mirror.size=quarter"
whole=$(bytes_of)
while IFS=, read -r _ setting _ bytes _; do
    same "$setting saves the bytes of the plan" "$((whole - $(bytes_of --set "$setting")))" \
        "$bytes"
done <rams
run plan minimal --size 320x240 --csv
same "a scene without a pool or a mirror has no such values" "$(grep -c '^less ram,' out)" 0
cost_of() {
    run plan "$1" --csv --size 320x240 --set "quality.error_px=$2" \
        --set "quality.error_colour=$2"
    awk -F, '$1 == "total" { print $4 }' out
}
last=
for budget in 0 0.5 1 2 4 8 16 32 64; do
    cost=$(cost_of count-64 $budget)
    [ -n "$last" ] && [ "$cost" -gt "$last" ] && echo "$budget costs $cost" >>dearer
    last=$cost
done
same "a larger budget never costs more" "$(cat dearer 2>/dev/null)" ""
run render minimal --size 64x48 --frames 40 --hash
cp out list
run render minimal --size 64x48 --frames 40 --hash --set quality.frame_ms=10000
same "within its time a frame is drawn as planned" "$code $(cat out)" "0 $(cat list)"

# A scene that names a board is drawn by the rows that the plan prints for it.
run plan storm --board stm32f405 --size 64x48 --csv
set -- $(tail -1 out | cut -d, -f4 | sed 's/[^ ][^ ]*/--set &/g')
[ $# -gt 8 ] || set -- --no-rows
run render storm --size 64x48 --frames 40 --hash --rung exact "$@"
cp out list
run render storm --size 64x48 --frames 40 --hash --set quality.board=stm32f405
same "a board's picture has the rows of its plan" "$code $(cat out)" "0 $(cat list)"
run render storm --size 64x48 --frames 40 --hash
same "and is another than the one without a board" \
    "$(cmp -s out list || echo another)" another

# A board in the scene's file changes neither --rung exact nor the steps of the ladder.
{ sed "s|= \\.\\./|= $root/assets/|" "$root/assets/scenes/storm.ini"
  printf '[quality]\nboard = stm32f405\n'; } >board.ini
for rung in "--rung exact" "--rung named" "--step 0" "--step 9"; do
    # shellcheck disable=SC2086
    run render storm --size 64x48 --frames 3 --hash $rung
    cp out list
    # shellcheck disable=SC2086
    run render board.ini --size 64x48 --frames 3 --hash $rung
    same "a board does not change $rung" "$code $(cat out)" "0 $(cat list)"
done
run plan storm --board rp2350 --size 64x48 --csv
cp out list
run plan board.ini --board rp2350 --size 64x48 --csv
same "nor the plan for another board" "$code $(cat out)" "0 $(cat list)"

# ini NAME CODE PATTERN TEXT...: runs a scene file with these lines.
ini() {
    name=$1 want=$2 pattern=$3
    shift 3
    printf '%s\n' "$@" >harbour.ini
    run render harbour.ini --size 16x16 --hash
    judge "$name" "$want" "$pattern"
}
ini "a scene of nothing but defaults" 0 "" "; nothing"
ini "line that is no setting" 3 "^harbour.ini:2: neither" "[wave0]" "steepness" \
    "length = 9"
ini "section that does not close" 3 "^harbour.ini:1: neither" "[wave0" "steepness = 0.1"
ini "unknown name" 3 "^harbour.ini:3: .*did you mean wave0.steepness?" "" "[wave0]" \
    "steepnes = 0.4"
ini "a name without a successor" 3 \
    "^harbour.ini:2: quality.lod is gone, grid.vertices sets .*; delete it$" "[quality]" \
    "lod = off"
ini "an old name" 0 \
    "^harbour.ini:2: pool.poke is now called pool.splash_height; .*check harbour.ini --write" \
    "[pool]" "poke = 0.3"
same "one line tells of all old names of a file" "$(
    printf '%s\n' "[pool]" "poke = 0.3" "feed = 0.1" >harbour.ini
    run render harbour.ini --size 16x16 --hash
    wc -l <err; sed 's/; .*//' err)" "1
harbour.ini:2: pool.poke is now called pool.splash_height (and 1 more old name)"
expect "an old name of the command line" 0 \
    "^--set: mirror.bend is now called mirror.distortion; " render minimal --size 16x16 \
    --hash --set mirror.bend=2
expect "a misspelt old name" 2 "did you mean mirror.distortion, once called mirror.bend?$" \
    render minimal --set mirror.bnd=2
# Lines of a grid are read as a budget of vertices.
waved() { ini "$1" 0 "$2" "[wave0]" "amplitude = 0.5" "length = 9" "[grid]" "$3" "$4"; }
waved "lines of a grid" "^harbour.ini:5: .*read as grid.vertices = 1365 until version" \
    "cols = 64" "rows = 64"
lines=$(cat out)
same "are told in one line" "$(wc -l <err)" 1
waved "a budget of vertices" "" "vertices = 1365" "; cell"
same "a third of the lines are the vertices" "$lines" "$(cat out)"
waved "lines beside a budget are not used" "" "cols = 64" "vertices = 1365"
same "and change nothing" "$lines" "$(cat out)"
expect "an old grid is rewritten" 0 "" check harbour.ini --write
ini "a pool has 3 in 5 of its lines" 0 \
    "^harbour.ini:2: .*read as grid.vertices = 3840 until version" "[grid]" "cols = 64" \
    "[pool]" "cols = 32"
ini "rings have so many" 0 "^harbour.ini:2: .*read as grid.vertices = 3840 until version" \
    "[grid]" "cols = 64" "[drops]" "count = 4"
ini "a tank without a sea has all" 0 \
    "^harbour.ini:2: .*read as grid.vertices = 6400 until version" "[grid]" "cols = 64" \
    "reach = 0" "[pool]" "cols = 32" "[tank]" "kind = glass"
ini "unknown section" 3 \
    "^harbour.ini:2: no parameter is called wive0.length; did you mean wave0.length?" \
    "[wive0]" "length = 3"
ini "value outside its range" 3 "^harbour.ini:4: wave0.steepness = 3 is outside 0..1$" \
    "# harbour" "[wave0]" "length = 9" "steepness = 3"
ini "value that is no number" 3 \
    "^harbour.ini:2: wave0.length: expected a number, found nine" \
    "[wave0]" "length = nine"
ini "number with a tail" 3 "^harbour.ini:2: wave0.length: expected a number" "[wave0]" \
    "length = 9m"
ini "empty value" 3 "^harbour.ini:2: wave0.length" "[wave0]" "length ="
ini "word that is no choice" 3 \
    "^harbour.ini:2: water.filter = cubic is none of .*linear" \
    "[water]" "filter = cubic"
ini "a value that the core refuses, by its check" 3 \
    "^harbour.ini:2: wave0.length: expected a number, found nine$" \
    "[wave0]" "length = nine"
expect "the same with its check" 3 "found nine \[src/world/value.c:[0-9]*\]$" \
    render harbour.ini --verbose
ini "both errors of a file, the first by line" 3 "^harbour.ini:2: neither" \
    "[wave0]" "steepness" "length = nine"
ini "comment of 4351 bytes" 0 "" "; $(printf '%04349d' 0)"
ini "comment of 4352 bytes" 3 "^harbour.ini:3: line longer than 4351 bytes" \
    "[wave0]" "length = 9" "; $(printf '%04350d' 0)"
ini "section of 200 bytes" 3 "^harbour.ini:2: line longer than 199 bytes" \
    "[wave0]" "[$(printf '%0198d' 0)]"
ini "name of 200 bytes" 3 "^harbour.ini:2: line longer than 199 bytes" \
    "[wave0]" "$(printf '%0200d' 0) = 1"
ini "over-long name" 3 "^harbour.ini:2: scene.title: longer than" "[scene]" \
    "title = $(printf '%0180d' 0)"
ini "indented lines, CRLF and comments" 0 "" "[wave0]" "  length = 9 ; metres" \
    "	amplitude = 0.3$(printf '\r')" "# done"
printf '\357\273\277[wave0]\nlength = 9' >harbour.ini
expect "byte order mark, no newline at the end" 0 "" render harbour.ini --size 16x16 --hash
printf '[wave0]\nlength = 9\nsteep\000ness = 1\n' >harbour.ini
expect "NUL byte" 3 "^harbour.ini:3: line with a NUL byte" render harbour.ini
printf '[wave0]\nlength = 9\nlength = 12\n' >harbour.ini
run params harbour.ini
same "the last of two settings holds" "$(awk '$1 == "wave0.length" { print $2 }' out)" 12
run params harbour.ini --set wave0.length=7 --set wave0.length=8
same "--set comes after the file, the last holds" \
    "$(awk '$1 == "wave0.length" { print $2 }' out)" 8

expect "--set without =" 2 "expected name=value" render minimal --set wave0.length
expect "--set of an unknown name" 2 "^--set: .*did you mean camera.fov?" render minimal \
    --set camera.fow=60
expect "--set outside the range" 2 "^--set: wave0.steepness = 3 is outside 0..1$" \
    render minimal --set wave0.steepness=3
steep="--set wave0.steepness=0.4 --set wave1.steepness=0.4 --set wave2.steepness=0.4"
tall="--set wave0.amplitude=1 --set wave1.amplitude=1 --set wave2.amplitude=1"
# shellcheck disable=SC2086
expect "clamp of the steepness sum" 0 \
    "^minimal: steepness sum 1.2[0-9]* is clamped to 0.95$" \
    render minimal --size 16x16 --hash $steep $tall

coarse="--set pool.cols=16 --set pool.rows=16 --set pool.cell_bits=8 --set pool.damping=10"
# shellcheck disable=SC2086
expect "a pool of cells too coarse for its numbers" 0 \
    "^--set: pool.courant: 8-bit cells have noise of 21 % of their range; 0.409 or more" \
    render minimal --size 16x16 --hash $coarse --set pool.courant=0.25
# shellcheck disable=SC2086
expect "and one that keeps to what is said" 0 "" \
    render minimal --size 16x16 --hash $coarse --set pool.courant=0.409
verdict "nothing is said of it" "$(cat err)"

ini "a cube without its pictures" 3 \
    "^harbour.ini:2: .*cube needs six pictures; sky.east names none$" "[sky]" "kind = cube"
expect "a cube of the command line" 3 "^--set: .*needs six pictures" render minimal \
    --set sky.kind=cube

# pools NAME PATTERN LINE...: a scene file with a pool and a field is refused.
pools() {
    name=$1 pattern=$2
    shift 2
    ini "$name" 3 "$pattern" "[pool]" "cols = 32" "rows = 32" "[field]" "cols = 32" \
        "rows = 32" "$@"
}
pools "a pool that is too fast" "^harbour.ini:8: pool.courant of 0.600 is above 0.497, " \
    "[pool]" "courant = 0.6"
pools "a field that is too fast" "^harbour.ini:8: field.courant of 0.500 is above 0.491" \
    "damping = 4" "courant = 0.5"
pools "too few columns" "^harbour.ini:8: pool.cols: pool of 7 x 32 cells; 16 x 16 to" \
    "[pool]" "cols = 7"
pools "a band upside down" "^harbour.ini:7: field.drive_min is above drive_max$" \
    "drive_min = 0.2" "drive_max = 0.1"
expect "a pool of the command line" 2 "^--set: pool.courant of 0.600 is above" \
    render minimal --set pool.cols=32 --set pool.courant=0.6
expect "rows of the command line" 2 "^--set: field.rows = 9 is outside 16..512 cells$" \
    render minimal --set field.cols=32 --set field.rows=9
expect "a mask that is not there" 3 "^--set: pool.mask: no.png: No such file" \
    render minimal --set pool.cols=32 --set pool.mask=no.png
expect "a map that is not there" 3 "^--set: floor.map: no.png: No such file" \
    render minimal --set floor.map=no.png
expect "a picture that is none" 3 "^--set: floor.map: harbour.ini: not a PNG$" \
    render minimal --set floor.map=harbour.ini

# -- files named by scenes ----------------------------------------------------------

small="render minimal --size 64x48 --hash"
printf 'v 0 0 0\nv 1 0 0\nv 1 x 0\nf 1 2 3\n' >bad.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n' >far.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >good.obj
printf 'mtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >lost.obj
printf 'mtllib sub\\red.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >red.obj
mkdir sub
printf 'newmtl red\nKd 1 0 0\nmap_Kd skin.png\n' >sub/red.mtl
# shellcheck disable=SC2086
{
expect "bad number in an OBJ" 3 "^bad.obj:3: expected a number, found x" \
    $small --set boat.mesh=bad.obj --out boat.png
absent "bad OBJ leaves no picture" "boat.png\|tidepool-"
expect "face of a vertex that is not there" 3 "^far.obj:4: face uses vertex 9 of 3" \
    $small --set boat.mesh=far.obj
expect "OBJ that does not exist" 3 "^--set: boat.mesh: no.obj: No such file" \
    $small --set boat.mesh=no.obj
# lacking NAME OBJ SENTENCE REMEDY: drawn with a warning; refused with --strict.
lacking() {
    expect "$1" 0 "^$3; $4\$" $small --set boat.mesh="$2"
    expect "$1, strictly" 3 "^$3\$" $small --set boat.mesh="$2" --strict --out boat.png
    absent "$1, strictly, leaves no picture" "boat.png\|tidepool-"
}
lacking "MTL that does not exist" lost.obj \
    "lost.obj:1: none.mtl: No such file or directory" "its materials are drawn in grey"
lacking "picture of an MTL that does not exist" red.obj \
    "sub/red.mtl:3: sub/skin.png: No such file or directory" "drawn without it"
printf '\377\330\377\340' >sub/skin.png
lacking "picture of an MTL that is a JPEG" red.obj \
    "sub/red.mtl:3: sub/skin.png: JPEG, expected PNG" "drawn without it"
for command in plan "bake -o red.c" "show --device /dev/null --frames 1" "view --frames 1"
do
    name=${command%% *} more=${command#"$name"}
    [ "$name" != view ] || [ -z "$unseen" ] || continue
    expect "$name --strict refuses it" 3 "^sub/red.mtl:3: sub/skin.png: JPEG" \
        "$name" minimal --set boat.mesh=red.obj --strict $more
done
printf 'newmtl red\nKd 1 q 0\n' >sub/red.mtl
lacking "bad number in an MTL" red.obj "sub/red.mtl:2: expected a number, found q" \
    "the line is left out"
printf 'newmtl blue\nKd 1 0 0\n' >sub/red.mtl
lacking "material that is not defined" red.obj "red.obj:2: material red is not defined" \
    "drawn in grey"
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\nf 1 2 3\nf 3\n' >thin.obj
lacking "faces of two corners" thin.obj "thin.obj: 2 faces of fewer than 3 corners" \
    "left out"
printf 'newmtl red\nKd 1 0 0\n' >sub/red.mtl
expect "OBJ with an MTL in a folder" 0 "" $small --set boat.mesh=red.obj
expect "OBJ without an MTL" 0 "" $small --set boat.mesh=good.obj
printf '\n[boat]\nmesh = parts/no.obj\n' >sub/own.ini
expect "names in an INI are beside it" 3 \
    "^sub/own.ini:3: boat.mesh: sub/parts/no.obj: No such file" \
    render sub/own.ini

expect "texture that does not exist" 3 "^--set: layer0.texture: no.png: No such file" \
    $small --set layer0.texture=no.png
ini "texture of a scene that does not exist" 3 \
    "^harbour.ini:4: layer1.texture: no.png: No such file" \
    "# harbour" "[layer1]" "size = 3" "texture = no.png"
ini "sky of a scene that lacks a side" 3 \
    "^harbour.ini:2: sky.kind: a cube needs six pictures; sky.east names none" "[sky]" "kind = cube"
run $small --out whole.png
head -c 200 whole.png >cut.png
expect "PNG cut short" 3 "cut.png: not a good PNG: the file ends too early" \
    $small --set layer0.texture=cut.png
head -c 4 whole.png >tiny.png
expect "PNG of four bytes" 3 "tiny.png: not a good PNG" $small --set \
    layer0.texture=tiny.png
: >empty.png
expect "PNG of nothing" 3 "empty.png: not a good PNG" $small --set \
    layer0.texture=empty.png
expect "OBJ for a PNG" 3 "good.obj: not a PNG$" $small --set layer0.texture=good.obj
{ head -c 300 whole.png; printf 'XXXX'; tail -c +305 whole.png; } >torn.png
expect "PNG with a torn chunk" 3 "torn.png: not a good PNG" $small --set \
    layer0.texture=torn.png
base64 -d >huge.png <<'PNG'
iVBORw0KGgoAAAANSUhEUgAA6mAAAOpgCAIAAAAPsOIVAAAADElEQVR4nGNgoD0AAABkAAGGZDw1
AAAAAElFTkSuQmCC
PNG
expect "PNG of 60000 x 60000 pixels" 3 "60000 x 60000 pixels; 4096 x 4096" $small \
    --set layer0.texture=huge.png
base64 -d >deep.png <<'PNG'
iVBORw0KGgoAAAANSUhEUgAAAAIAAAACEAYAAAFVIeHxAAAAHklEQVR4nGP4/58BCMAkiGhoYIDx
hUzCKmbt+f8fAN3WDWGRwh9WAAAAAElFTkSuQmCC
PNG
expect "PNG of 16 bits, interlaced" 0 "" $small --set layer0.texture=deep.png
for format in xrgb8888 rgb565 p8 l8 i1; do
    run $small --format $format --out $format.png
    expect "PNG of $format is read again" 0 "" $small --set layer0.texture=$format.png
done
expect "folder for a texture" 3 " sub: .*Is a directory" $small --set layer0.texture=sub
expect "folder for a mesh" 3 " sub: Is a directory" $small --set boat.mesh=sub
}

# -- memory ---------------------------------------------------------------------------

# The reported sum of a board's RAM is enough; one byte less is refused before anything is
# drawn. The sum is that of the plan.
need="three-swells --size 64x48 --threads 2"
# shellcheck disable=SC2086
{
expect "more memory than is allowed" 3 \
    "^three-swells needs [0-9]* bytes of RAM on a board (frame [0-9]*, tiles [0-9]*, "\
"world [0-9]*, stacks [0-9]*), --memory allows 65536; [0-9]* bytes of flash are not "\
"counted$" \
    render $need --memory 64k --out refused.png
absent "a picture that needs too much" "refused.png\|tidepool-"
bytes=$(sed -n 's/.* needs \([0-9]*\) bytes.*/\1/p' err)
expect "exactly the memory that is allowed" 0 "" render $need --memory "$bytes" --stats
expect "one byte less" 3 "needs $bytes bytes" render $need --memory $((bytes - 1))
run render $need --memory 1k
sum=$(sed 's/.*(//; s/).*//; s/[a-z ]*//g; s/,/ + /g' err)
same "figures add up to what is needed" "$(($sum))" "$bytes"
run plan three-swells --size 64x48 --band 8 --stream --csv      # streams before the refusal
sum=$(awk -F, '$1 == "ram" { sum += $4 } END { print sum }' out)
run render three-swells --size 64x48 --band 8 --format rgb565 --memory $((sum - 1))
same "it is what the plan prints" "$code $(sed 's/.* needs \([0-9]*\) .*/\1/' err)" "3 $sum"
}
# A sanitizer build does not start in so little memory; the plain build does.
if (ulimit -v 200000; timeout 60 "$program" --version >out 2>&1); then
    (ulimit -v 200000
     timeout 60 "$program" render minimal --size 4096x4096 --band 4096 --out big.png 2>err)
    code=$?
    judge "memory that the system has not" 3 \
        "^tidepool: out of memory: [0-9]* bytes needed$"
    absent "a picture without memory" "big.png\|tidepool-"
fi

# -- outputs ------------------------------------------------------------------------

small="render three-swells --size 64x48"
# shellcheck disable=SC2086
{
run $small --frames 2:4 --out f-%04d.png
same "one PNG a frame, numbered by frames" "$code $(echo f-*)" \
    "0 f-0002.png f-0003.png f-0004.png"
run $small --out 100%%-%d.png
same "%% is a percent sign" "$code $(echo 100*)" "0 100%-0.png"
run $small --frames 3 --out film.y4m
same "film has its header" "$code $(head -1 film.y4m)" \
    "0 YUV4MPEG2 W64 H48 F60:1 Ip A1:1 C420jpeg XCOLORRANGE=LIMITED"
header=$(head -1 film.y4m | wc -c)
same "film has its size" "$(wc -c <film.y4m)" "$((header + 3 * (6 + 64 * 48 * 3 / 2)))"
run render three-swells --size 33x17 --out odd.y4m
header=$(head -1 odd.y4m | wc -c)
same "film of odd sides has its size" "$(wc -c <odd.y4m)" \
    "$((header + 6 + 33 * 17 + 2 * 17 * 9))"
run $small --frames 3 --out - --hash --stats
cmp -s out film.y4m
same "film on standard output is the same, hashes and figures on stderr" \
    "$? $(grep -c '^frame 000[012] crc32 ' err) $(grep -c '^{.*}$' err)" "0 3 1"
run $small --frames 2 --stats
for key in frames ms_median water_pixels vertices triangles dropped ram_bytes; do
    grep -q "\"$key\": " out || echo "no $key" >>missing
done
same "figures have all their keys" "$code $(cat missing 2>/dev/null)" "0 "
same "figures count two frames and some water" \
    "$(grep -c '"frames": 2,.*"water_pixels": [1-9]' out)" 1

expect "full device" 3 "^/dev/full: No space" $small --frames 9 --out /dev/full
timeout 60 "$program" $small --frames 9 --out - >/dev/full 2>err
code=$?
judge "full standard output" 3 "^standard output: No space"
timeout 60 "$program" $small --hash >/dev/full 2>err
code=$?
judge "hashes to a full device" 3 "^standard output: No space"
ln -s /dev/full full.png
expect "PNG to a full device" 3 "^full.png: No space" $small --out full.png
rm full.png
(ulimit -f 1; timeout 60 "$program" $small --frames 99 --out cut.y4m 2>err)
code=$?
judge "film beyond the size limit" 3 "^cut.y4m: File too large"
(ulimit -f 1; timeout 60 "$program" render three-swells --out big.png 2>err)
code=$?
judge "PNG beyond the size limit" 3 "^big.png: File too large"
expect "output into no folder" 3 "^no/film.y4m: No such file" $small --out no/film.y4m
mkdir taken.png
expect "a folder of the output's name" 3 "^taken.png: Is a directory" $small --out \
    taken.png
absent "failed outputs leave nothing" "cut.y4m\|big.png\|full.png\|tidepool-"
{ timeout 60 "$program" $small --frames 99 --out - 2>err; echo $? >code; } | head -c 9 \
    >/dev/null
code=$(cat code)
judge "closed pipe" 3 "^standard output: Broken pipe"

run $small --frames 300 --out whole.y4m
timeout 60 "$program" $small --frames 300 --out film.y4m --hash >&- 2>err
code=$?
judge "closed standard output" 3 "^standard output: Bad file descriptor$"
verdict "the film holds no hashes" "$(cmp film.y4m whole.y4m 2>&1)"
timeout 60 "$program" $small --out film.png --memory 1 2>&-
same "closed standard error" "$? $(ls film.png 2>/dev/null)" "3 "
timeout 60 "$program" $small <&- >out 2>err
same "closed standard input" "$? $(cat err)" "0 three-swells.png: frame 0, 64x48"
for command in help version scenes params manual "plan minimal" "render --help"; do
    { sleep 0.1; timeout 60 "$program" $command 2>err; echo $? >code; } | true
    same "$command goes on into what reads no line, without a word" \
        "$(cat code) $(cat err)" "141 "
done
timeout 60 "$program" bake minimal -o - >/dev/full 2>err
same "a full disk is told once" "$? $(cat err)" "3 standard output: No space left on device"
rm -f whole.y4m film.y4m three-swells.png

timeout 60 "$program" $small --frames 1000000 --out long.y4m 2>err &
child=$!
for _ in 1 2 3 4 5 6 7 8 9; do
    ls -A | grep -q tidepool- && break
    sleep 0.1
done
same "a film being written has another name" "$(ls -A | grep -c 'long.y4m\|tidepool-')" 1
kill $child
wait $child 2>/dev/null
absent "a film that is stopped leaves nothing" "long.y4m\|tidepool-"
echo old >keep.y4m
ln keep.y4m other.y4m
run $small --out keep.y4m
same "an old file is replaced, not written into" "$code $(cat other.y4m)" "0 old"
ln -s keep.y4m link.y4m
run $small --out link.y4m --frames 2
same "a link to a file is followed" "$code $(test -L link.y4m && wc -c <keep.y4m)" \
    "0 $(head -1 keep.y4m | wc -c | awk '{ print $1 + 2 * (6 + 64 * 48 * 3 / 2) }')"
}

# -- hashes -------------------------------------------------------------------------

# shellcheck disable=SC2086
{
run $small --frames 0:5 --hash
cp out list
same "one hash a frame" "$code $(grep -c '^frame 000[0-5] crc32 [0-9a-f]\{8\}$' list)" \
    "0 6"
same "frames differ from each other" "$(cut -d' ' -f4 list | sort -u | wc -l)" 6
expect "the right list" 0 "" $small --frames 0:5 --hash --expect list
expect "a part of the list" 0 "" $small --frames 3:4 --hash --expect list
run $small --frames 5:5 --hash
same "a frame rendered alone is the same" "$(cat out)" "$(tail -1 list)"
known=$(sed -n 's/frame 0003 crc32 //p' list)
sed 's/\(frame 0003 crc32 \).*/\1deadbeef/' list >wrong
expect "the wrong list" 1 "^wrong: frame 0003 differs: expected deadbeef, got $known$" \
    $small --frames 0:5 --hash --expect wrong
same "the wrong list ends at the first difference" "$(wc -l <out)" 4
run $small --frames 0:5 --expect wrong --out differs.y4m
absent "no film of a failed check" "differs.y4m\|tidepool-"
grep -v 0004 list >short
expect "a frame that the list lacks" 1 "^short: frame 0004 is not in the list" \
    $small --frames 0:5 --expect short
: >none
expect "an empty list" 1 "not in the list" $small --expect none
{ echo '# hashes'; echo; cat list; } >noted
expect "comments in a list" 0 "" $small --frames 0:5 --expect noted
echo 'frame 0000 crc 12345678' >broken
expect "a line that is no hash" 3 "^broken:1: expected 'frame" $small --expect broken
expect "a list that does not exist" 3 "^no.txt: No such file" $small --expect no.txt
for format in xrgb8888 rgb565 rgb565be p8 l8 i1; do
    whole="render three-swells --size 100x70 --frames 2 --format $format --hash"
    run $whole
    cp out hashes
    for tiling in "--band 1" "--band 7" "--band 16" "--strip 16" "--strip 48" \
        "--strip 112" \
                  "--threads 2" "--threads 3 --strip 16" "--threads 5 --band 3"; do
        run $whole $tiling
        same "$format, $tiling: the same frames" "$code $(cat out)" "0 $(cat hashes)"
    done
done
}

# -- progress -----------------------------------------------------------------------

long="timeout 3 $program render minimal --size 1024x768 --frames 1000000 --stats"
$long >out 2>err &
if on_terminal "progress on a terminal"; then
    TERM=xterm script -qec "$long" typescript >/dev/null </dev/null
    same "after two seconds a terminal sees progress" \
        "$(grep -c 'frame [0-9]* of 1000000, 0%, about [0-9]* s left' typescript)" 1
fi
wait $!
same "a file does not" "$(cat out err)" ""

finish
