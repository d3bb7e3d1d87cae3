#!/bin/sh
# SPDX-License-Identifier: MIT
# Raw screens without a screen: a fake frame buffer and console are loaded below the
# program (screen_fake.c).  Checks refusals, pictures in memory, and the restored state
# after every kind of death.  Real screens: tests/boards.
#     screen.sh PROGRAM
build=$(realpath "${TP_BUILD:-build/host}") || exit 2
. "$(dirname "$0")/../lib/script.sh"
program_begin "$1"
fake=$build/screen_fake.so
crc_of=$build/tests/host/screen_crc

scene=minimal
wide="96 64 32 384 64 2 16 8 8 8 0 8 24 8 0 0"      # format: see screen_fake.c
export FAKE_LOG="$work/log"

# memory DESCRIPTION: makes the screen's memory of noise, and a copy.
memory() {
    FAKE_FB=$1
    export FAKE_FB
    set -- $FAKE_FB
    yes 'what was on the screen' | head -c $(($4 * $5)) >fb0
    cp fb0 before
    : >log
}

# begin ARGUMENT...: starts the program in the background; returns after the first
# picture.
begin() {
    rm -f out
    LD_PRELOAD=$fake "$program" show "$scene" --device fb0 --hash "$@" \
        >out 2>err </dev/null &
    parent=$!
    waited=0
    until grep -qs '^frame' out || ! kill -0 $parent 2>/dev/null; do
        waited=$((waited + 1))
        [ $waited -lt 600 ] || break
        sleep 0.05
    done
    child=$(cat /proc/$parent/task/$parent/children 2>/dev/null)
    child=${child%% *}
}

# last_frame: prints the number of the last shown frame.
last_frame() {
    tail -1 out | awk '{ print $2 + 0 }'
}

# end SIGNAL PROCESS: sends a signal; the exit code, as a shell reports it, is in $code.
end() {
    kill -s "$1" "$2"
    { wait $parent; } 2>/dev/null
    code=$?
}

# gone PROCESS: true if the process ends within a while.
gone() {
    waited=0
    while kill -0 "${1:-0}" 2>/dev/null && [ $waited -lt 200 ]; do
        waited=$((waited + 1))
        sleep 0.02
    done
}

# given_back: prints "", or the state that was not restored.
given_back() {
    cmp -s fb0 before || echo "the screen has changed"
    [ -z "$FAKE_VT" ] || [ "$(grep '^mode' log | tail -1)" = "mode 0" ] ||
        echo "the console is in graphics mode"
    [ -z "$FAKE_VT" ] || [ "$(grep '^switching' log | tail -1)" = "switching 0" ] ||
        echo "the console's switching has changed"
    case $FAKE_FB in *' 1') [ "$(grep '^pan' log | tail -1)" = "pan 0" ] ||
        echo "it is panned" ;; esac
}

# -- refusals -------------------------------------------------------------------------

echo text >text
mkdir folder
expect "no such device" 4 "^nowhere: cannot be opened: No such file" \
    show $scene --device nowhere
same "and that in one line" "$(wc -l <err)" 1
expect "a folder" 4 "^folder: cannot be opened: Is a directory" show $scene --device folder
expect "a file" 4 "^text: is not a frame buffer$" show $scene --device text
expect "another device" 4 "^/dev/null: is not a frame buffer$" show $scene --device /dev/null
expect "no such port" 2 "expected fb or kms" show $scene --on paper
expect "--hold without --frames" 2 "hold" show $scene --hold
expect "no such scene" 3 "nothing.ini" show nothing.ini --device text

# refused NAME CODE PATTERN ARGUMENT...: refused on the fake screen; nothing is changed.
refused() {
    name=$1 want=$2 pattern=$3
    shift 3
    LD_PRELOAD=$fake timeout 20 "$program" show $scene --device fb0 "$@" \
        >out 2>err </dev/null
    code=$?
    judge "$name" "$want" "$pattern"
    [ "$(wc -l <err)" -eq 1 ] || verdict "$name: one line" "$(cat err)"
    cmp -s fb0 before || verdict "$name: nothing has changed" "the screen has"
}
printf '[wave0]\namplitude = 0.3\nlength = 8\n' >plain.ini
memory "$wide"
chmod 755 .
chmod 000 fb0
as=
[ "$(id -u)" -ne 0 ] || as='setpriv --reuid 65534 --clear-groups'
cp "$program" copy
$as ./copy show plain.ini --device fb0 >out 2>err </dev/null
code=$?
judge "no permission" 4 "^fb0: cannot be opened: Permission denied"
chmod 600 fb0
rm -f copy
memory "$wide"
refused "smaller than the picture" 4 "^fb0: 96x64 pixels, smaller than .* 97x64$" --size 97x64
memory "15 64 32 384 64 2 16 8 8 8 0 8 24 8 0 0"
refused "smaller than any picture" 4 "15x64 pixels; a scene needs at least 16x16"
for bad in "96 64 4 384 64 2 0 4 0 4 0 4 0 0 0 0" "96 64 32 384 64 2 16 8 16 8 0 8 0 0 0 0" \
           "96 64 32 384 64 0 16 8 8 8 0 8 0 0 0 0" "96 64 32 380 64 2 16 8 8 8 0 8 0 0 0 0" \
           "96 64 32 384 60 2 16 8 8 8 0 8 0 0 0 0" "96 64 8 96 64 4 0 8 0 8 0 8 0 0 0 0"; do
    memory "$bad"
    refused "a strange layout: $bad" 4 "^fb0: unknown pixel layout"
done
memory "96 64 8 96 64 3 0 8 0 8 0 8 0 0 0 0"
refused "colours that indices do not have" 4 "8 bits a pixel take p8, l8 or i1, not rgb565" \
    --format rgb565
memory "$wide"
export FAKE_VT=1
refused "a console that another program draws on" 4 "^the console is busy"
FAKE_VT=0
begin --frames 0:0 --hold
LD_PRELOAD=$fake timeout 20 "$program" show $scene --device fb0 >out2 2>err </dev/null
code=$?
judge "a screen that shows a scene already" 4 "^fb0: busy"
end TERM $parent
verdict "it went on, and gave back" "$(given_back)"

# -- pictures ------------------------------------------------------------------------

# drawn NAME DESCRIPTION FIRST_LINE FORMAT [TABLE]: expects frame 7 in memory.
drawn() {
    name=$1 first=$3 format=$4 table=$5
    memory "$2"
    want=$("$program" render $scene --size 96x64 --format $format --frames 7:7 --hash |
           awk '{ print $4 }')
    begin --frames 5:7 --hold
    while [ "$(grep -c '^frame' out)" -lt 3 ] && kill -0 $parent 2>/dev/null; do
        sleep 0.05
    done
    sleep 0.05
    same "$name" "$("$crc_of" fb0 "$FAKE_FB" $first 0 0 96 64 $table)" "$want"
    same "$name: so does the program" "$(awk '/0007/ { print $4 }' out)" "$want"
    end TERM $parent
    verdict "$name: given back" "$(given_back)"
}
drawn "32 bits" "$wide" 0 xrgb8888
drawn "32 bits, blue high, long lines" "96 64 32 500 64 2 0 8 8 8 16 8 24 8 0 0" 0 xrgb8888
drawn "24 bits" "96 64 24 288 64 2 16 8 8 8 0 8 0 0 0 0" 0 xrgb8888
drawn "16 bits" "96 64 16 192 64 2 11 5 5 6 0 5 0 0 0 0" 0 rgb565
drawn "two pages, the third picture in the second" \
    "96 64 32 384 128 2 16 8 8 8 0 8 24 8 0 1" 64 xrgb8888
same "the second page was panned to" "$(grep '^pan' log | tr '\n' ' ')" \
    "pan 64 pan 0 pan 64 pan 0 "
drawn "8 bits of a table" "96 64 8 96 64 3 0 8 0 8 0 8 0 0 0 0" 0 p8 p8
same "the table was set and given back" "$(grep '^table' log | tr '\n' ' ')" \
    "table 0000 2b2b 3333 table 0000 0000 0000 "
drawn "greys" "96 64 8 96 64 2 0 8 0 8 0 8 0 0 1 0" 0 l8 l8
drawn "channels through a table" "96 64 16 200 64 4 11 5 5 6 0 5 0 0 0 0" 0 rgb565
memory "$wide"
want=$("$program" render $scene --size 64x48 --hash | awk '{ print $4 }')
begin --frames 0:0 --hold --size 64x48
sleep 0.05
same "a smaller picture is centred" "$("$crc_of" fb0 "$wide" 0 16 8 64 48)" "$want"
same "and nowhere else" "$("$crc_of" fb0 "$wide" 0 15 8 64 48 | grep -c "$want")" 0
same "black is above it" "$("$crc_of" fb0 "$wide" 0 0 0 96 8)" \
    "$(head -c 3072 /dev/zero >zero; "$crc_of" zero "$wide" 0 0 0 96 8)"
end TERM $parent

# -- deaths --------------------------------------------------------------------------

memory "96 64 32 384 128 2 16 8 8 8 0 8 24 8 0 1"
LD_PRELOAD=$fake timeout 20 "$program" show $scene --device fb0 --frames 3 >out 2>err \
    </dev/null
same "it ends by itself" "$? $(wc -l <err)" "0 0"
verdict "and gives back" "$(given_back)"
for signal in INT TERM HUP QUIT SEGV ABRT BUS KILL; do
    for to in child parent; do
        : >log
        begin --frames 0:0 --hold
        who=$parent
        [ $to = parent ] || who=$child
        cmp -s fb0 before && verdict "SIG$signal: something was drawn" "nothing was"
        end $signal $who
        gone "$child"
        same "SIG$signal to the $to ends it so" "$(kill -l $code)" $signal
        verdict "SIG$signal to the $to: given back" "$(given_back)"
    done
done

# Every call up to the first picture fails in turn.  If a driver claims to pan but fails,
# one page is used.
memory "96 64 8 96 128 3 0 8 0 8 0 8 0 0 0 1"
want=$("$program" render $scene --size 96x64 --format p8 --hash)
failing=1
while [ $failing -lt 40 ]; do
    : >log
    FAKE_FAIL=$failing LD_PRELOAD=$fake timeout 20 "$program" show $scene --device fb0 \
        --frames 1 --hash >out 2>err </dev/null
    code=$?
    wrong=$(given_back)
    case $wrong in *console*) grep -q '^mode 1' log || wrong= ;; esac
    case $wrong in *panned*) grep -q '^pan' log || wrong= ;; esac
    what="call $failing fails ($(awk '/failed/ { print $2 }' log))"
    case $code in
    4) same "$what: one line" "$(wc -l <err)" 1 ;;
    *) same "$what: it is drawn all the same" "$code $(cat out)" "0 $want" ;;
    esac
    verdict "$what: given back" "$wrong"
    ! grep -q 'failed 4606' log || break            # FBIOPAN_DISPLAY, the last call
    failing=$((failing + 1))
done
same "those were all" "$((failing > 8 && failing < 40))" 1

# A panel that never answers, and a stopped child.
memory "96 64 32 384 128 2 16 8 8 8 0 8 24 8 0 1"
rm -f out
FAKE_HANG=1 LD_PRELOAD=$fake "$program" show $scene --device fb0 >out 2>err </dev/null &
parent=$!
sleep 0.5
begun=$(date +%s)
end TERM $parent
same "a panel that blocks: it ends as it was asked to" "$(kill -l $code)" TERM
took=$(($(date +%s) - begun))
same "after three seconds" "$((took > 1 && took < 8))" 1
verdict "and given back" "$(given_back)"
: >log
begin --frames 0:0 --hold
kill -s STOP "$child"
end TERM $parent
same "one that is stopped ends" "$(kill -l $code)" TERM
verdict "and gives back" "$(given_back)"

# -- a lost screen ---------------------------------------------------------------------

FAKE_GONE=$work/gone
export FAKE_GONE
memory "$wide"
begin
touch gone
end CONT "$child"
same "unplugged, it ends by itself" "$code" 5
same "and says so in one line" "$(cat err)" "fb0: the display is lost: No such device"
rm gone
unset FAKE_GONE

# -- another terminal is active ----------------------------------------------------------

begin
kill -s USR1 "$child"
sleep 0.3
shown=$(grep -c '^frame' out)
sleep 0.3
same "away: no picture is drawn" "$(grep -c '^frame' out)" "$shown"
same "and the kernel was told" "$(tail -1 log)" "release 1"
kill -s USR2 "$child"
sleep 0.4
[ "$(grep -c '^frame' out)" -gt "$shown" ]
same "back: they go on" $? 0
same "and the kernel was told of that" "$(grep '^release' log | tail -1)" "release 2"
end INT $parent
verdict "and it gives back" "$(given_back)"

# -- time ---------------------------------------------------------------------------

begin
kill -s STOP "$child"
sleep 2
before_it=$(last_frame)
kill -s CONT "$child"
sleep 0.2
end TERM $parent
after=$(last_frame)
[ "$after" -gt "$before_it" ] && [ $((after - before_it)) -lt 60 ]
same "stopped for two seconds, it does not make them up" $? 0

# -- keys ----------------------------------------------------------------------------

if on_terminal "keys on a terminal"; then
    unset FAKE_VT
    cat >keys.sh <<END
stty -g >modes
LD_PRELOAD='$fake' '$program' show $scene --device fb0 --hash >out 2>err
echo \$? >code
stty -g >>modes
END
    typed() { sleep 1; printf "$1"; sleep 1; }
    typed 'wwd\033' | timeout 20 script -qec 'sh keys.sh' /dev/null >told 2>&1
    same "Esc ends it" "$(cat code)" 0
    same "the terminal's mode is as it was" "$(sort -u modes | wc -l)" 1
    same "keys are not echoed" "$(grep -c w told)" 0
    typed '\003' | timeout 20 script -qec 'sh keys.sh' /dev/null >told 2>&1
    same "Ctrl-C is SIGINT" "$(cat code)" 130
    same "and the terminal's mode is as it was" "$(sort -u modes | wc -l)" 1
fi

# -- kept worlds -------------------------------------------------------------------------

FAKE_VT=0
export FAKE_VT
scene=${keep_scene:-tank}
memory "$wide"
whole() {
    LD_PRELOAD=$fake timeout 60 "$program" show $scene --device fb0 --hash "$@" \
        >out 2>err </dev/null
    code=$?
}
whole --frames 0:150
same "an uninterrupted run" "$code $(grep -c '^frame' out)" "0 151"
mv out all
begin --frames 0:150 --keep world
until [ -s world ] || ! kill -0 $parent; do sleep 0.05; done
same "with nothing kept it begins, and says so in one line" "$(cat err)" \
    "world: no saved world: a fresh start"
sleep 0.4
end KILL "$child"
same "killed amid" "$(kill -l $code)" KILL
reached=$(last_frame)
cp world killed
whole --frames 0:150 --keep world
again=$(awk 'NR == 1 { print $2 + 0 }' out)
same "it goes on" "$code $(grep -c "continues at frame $again" err)" "0 1"
[ "$again" -gt 0 ] && [ "$again" -le "$reached" ]
same "from before it was killed" $? 0
same "to the end" "$(last_frame)" 150
same "by the frames of the uninterrupted run" "$(tail -n $((151 - again)) all | cmp - out)" ""
same "and it is not another run" "$(tail -n $((150 - again)) all | cmp -s - out; echo $?)" 1
whole --frames 0:150 --keep world
same "at the end it has nothing to draw but the end" "$(cat out)" "$(tail -1 all)"
whole --frames 0:100 --keep world
judge "one that is past the frames" 3 "already at frame 150, past 100"

FAKE_SLOW=1
export FAKE_SLOW
begin --keep slow
sleep 2.5
shown=$(last_frame)
same "a slow disk holds up no picture ($shown after 2.5 s)" "$((shown > 90))" 1
end TERM $parent
unset FAKE_SLOW
kept=$(od -An -tu4 -j16 -N4 slow | tr -d ' ')
same "and has the last one in the end" "$((kept >= $(last_frame)))" 1
rm slow

# fresh NAME PATTERN: the kept file `world` is refused, and the run starts at frame 0.
fresh() {
    whole --frames 0:1 --keep world
    judge "$1" 0 "^world: $2: a fresh start$"
    same "$1: from frame 0" "$(cat out)" "$(head -2 all)"
}
bytes=$(wc -c <killed)
head -c $((bytes - 1)) killed >world
fresh "cut off" "is incomplete"
{ cat killed; printf x; } >world
fresh "longer" "is incomplete"
{ head -c $((bytes / 2)) killed; printf '\252\125'; tail -c +$((bytes / 2 + 3)) killed; } >world
fresh "altered" "is incomplete"
: >world
fresh "empty" "is not a saved world"
cp fb0 world
fresh "something else" "is not a saved world"
{ head -c 12 killed; printf '\252\125'; tail -c +15 killed; } >world
fresh "of another build" "was saved by another build"
{ head -c 7 killed; printf '\002'; tail -c +9 killed; } >world
fresh "of an older version" "holds a world of version 2, this program has version 6"
cp killed world
whole --frames 0:1 --keep world --set wave0.length=9
judge "of a changed scene" 0 "^world: belongs to another scene: a fresh start$"
rm -rf world && mkdir world world.new
whole --frames 0:1 --keep world
judge "what cannot be kept" 3 "^world: cannot be saved: "
same "is drawn all the same" "$(grep -c '^frame' out)" 2

# -- tapes -----------------------------------------------------------------------------

rm -rf world world.new
{ echo "tape 2 $scene"; echo "5 drops=1"; echo "9 look turn=90000000"
  echo "9 set light.elevation=20"; echo "9 ahead=0.1"; echo "20 set grid.vertices=1089"
  echo "20 set camera.y=3"; echo "31 set light.elevation=60"; } >walk.tape
"$program" render "$scene" --size 96x64 --frames 40 --hash --tape walk.tape >all 2>err
whole --frames 0:39 --tape walk.tape
same "a tape's inputs, looks and changes" "$code $(cmp all out)" "0 "
whole --frames 0:25 --keep world --tape walk.tape
whole --frames 0:39 --keep world --tape walk.tape
same "go on from a world that was kept" "$code $(tail -n 15 all | cmp - out)" "0 "
rm world
{ echo "tape 2 $scene"; echo "2 drops=1"; echo "5 slower=2"; echo "12 ahead=0.1"
  echo "18 set clock.scale=0.125"; echo "30 slower=-1"; echo "33 ahead=0.1"; } >slow.tape
whole --frames 0:39 --tape slow.tape
mv out all
seen=$(cut -d' ' -f4 all | sort -u | wc -l)
same "a tape of slow motion ($seen pictures)" "$code $((seen > 20))" "0 1"
whole --frames 0:25 --keep world --tape slow.tape
whole --frames 0:39 --keep world --tape slow.tape
same "in slow motion too" "$code $(tail -n 15 all | cmp - out)" "0 "
{ echo "tape 2 $scene"; echo "3 drops=1"; echo "4 set pool.cols=40"; } >anew.tape
refused "a tape that makes the world anew" 3 \
    "^anew.tape:3: pool.cols=40 restarts the world, .* only changes that keep the world" \
    --tape anew.tape

finish
