#!/bin/sh
# SPDX-License-Identifier: MIT
# Exit codes have one meaning.  Each command and each script of ports/ is led to every
# exit code it knows; a command's --help lists exactly these codes.
#     exits.sh PROGRAM
build=$(realpath "${TP_BUILD:-build/host}") || exit 2
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/display.sh"
program_begin "$1"
HOME=$work XDG_STATE_HOME=$work/state XDG_CONFIG_HOME=$work/config
export HOME XDG_STATE_HOME XDG_CONFIG_HOME
unset DISPLAY WAYLAND_DISPLAY SDL_VIDEODRIVER
: >met

# exits CODE PATTERN COMMAND ARGUMENT...: checks the code and a line of the output or of
# stderr; PATTERN "" checks no line.
exits() {
    want=$1 pattern=$2
    shift 2
    run "$@"
    met "$1" "$want" "$pattern" "$*"
}
met() {         # COMMAND CODE PATTERN NAME
    if [ "$code" -ne "$2" ] || { [ -n "$3" ] && ! grep -q -e "$3" err out; }; then
        verdict "$4" "exit code $code, expected $2 and '$3'"
    else
        verdict "$4: exit code $2" ""
        echo "$1 $2" >>met
    fi
}
# full COMMAND ARGUMENT...: runs with a full disk as standard output.
full() {
    timeout $limit "$program" "$@" >/dev/full 2>err </dev/null
    code=$?
    met "$1" 3 "standard output: No space" "$* to a full disk"
}

# -- every command ----------------------------------------------------------------------

exits 0 "frame 0000" render minimal --size 32x32 --hash
echo "frame 0000 crc32 00000000" >list
exits 1 "differs" render minimal --size 32x32 --expect list
exits 2 "expected WIDTHxHEIGHT" render minimal --size 1
exits 3 "No such file" render nowhere.ini
run render minimal --size 32x32 --out a.y4m
exits 0 "" join b.y4m a.y4m
exits 2 "needs FILM.y4m and PART.y4m" join b.y4m
exits 3 "No such file" join b.y4m nowhere.y4m
for command in scenes manual version; do
    exits 0 "storm\|0\." $command
    exits 2 "too many names" $command a
    full $command
done
exits 0 "render" help
exits 2 "no command" help sail
full help
exits 0 "wave0" params minimal
exits 2 "no option" params --sett
exits 3 "No such file" params nowhere.ini
exits 0 "" bake minimal -o a.c
exits 1 "the scene uses it: .* haze" bake minimal -o a.c --size 32x32 --without haze --strict
exits 2 "-o FILE.c is missing" bake minimal
exits 3 "No such file" bake minimal -o no/a.c
exits 0 "in all" plan minimal
exits 2 "SCENE is missing" plan
exits 3 "No such file" plan nowhere.ini
mkdir tables
head -20 "$vectors/sine.csv" >tables/sine.csv
exits 0 "sine" check --vectors tables
awk -F, -v OFS=, '/^[^#]/ && ++n == 2 { $NF = 65536 - $NF } { print }' tables/sine.csv \
    >wrong
mv wrong tables/sine.csv
exits 1 "sine" check --vectors tables
exits 2 "vectors DIR is missing" check
exits 3 "No such file" check --vectors nowhere
exits 0 "plain" bench --size 64x48 --points 16 --frames 1
exits 2 "expected" bench --points 0
exits 3 "project's folder" bench --peers
mkdir charts
: >charts/style.gp
: >charts/svg.awk
echo '# Page' >charts/page.md
echo text >charts/demo.txt
printf '[chart]\ntitle = Demo\nkeys = k\nvalues = v\njob = %s\n' 'echo "demo,a,v,1"' \
    >charts/demo.ini
exits 0 "" charts out.d --from charts --small
sed -i 's/^job.*/job = false/' charts/demo.ini
exits 1 "exit 1: false" charts out.d --from charts --small
exits 2 "DIR is missing" charts
exits 3 "no chart in this folder" charts out.d --from tables
exits 0 "complete" completion bash
exits 2 "expected bash, zsh or fish" completion csh
full completion bash

# -- screens: none, a present one, a lost one -------------------------------------------

FAKE_FB="96 64 32 384 64 2 16 8 8 8 0 8 24 8 0 0" FAKE_GONE=$work/gone
export FAKE_FB FAKE_GONE
head -c 24576 /dev/zero >fb0
check "the fake screen is built" test -f "$build/screen_fake.so"
[ "$failed" = 0 ] || exit 1     # else `show` would wait for a real screen
show() {        # ARGUMENT...: on a fake screen (screen_fake.c)
    LD_PRELOAD=$build/screen_fake.so timeout $limit "$program" show "$@" >out 2>err \
        </dev/null
    code=$?
}
show minimal --device fb0 --frames 1 --hash
met show 0 "^frame 0000" "show"
exits 2 "expected fb or kms" show minimal --on paper
exits 3 "No such file" show nowhere.ini
exits 4 "cannot be opened" show minimal --device nowhere
exits 4 "is not a frame buffer" show minimal --device list
show minimal --device fb0 --size 97x64
met show 4 "smaller than the picture" "show, larger than its screen"
: >out
{ until_true grep -q '^frame' out; touch gone; } &
show minimal --device fb0 --hash
wait
met show 5 "the display is lost" "show, whose screen is unplugged"

# -- windows ----------------------------------------------------------------------------

lose_display() {
    begin_server 640x480
    SDL_VIDEODRIVER=x11 timeout $limit "$program" view minimal \
        --size 160x120 >out 2>err </dev/null &
    viewer=$!
    until_true test -s state/tidepool/session.ini       # a second of frames
    kill $server
    { wait $server; wait $viewer; } 2>/dev/null
    code=$? server="" viewer=""
    unset DISPLAY
}
if "$program" view --help 2>&1 | grep -q "built without"; then
    exits 4 "built without the preview" view minimal
    sed -i '/^view/d' met
else
    SDL_VIDEODRIVER=dummy timeout $limit "$program" view minimal --frames 2 >out 2>err
    code=$?
    met view 0 "" "view"
    SDL_VIDEODRIVER=dummy timeout $limit "$program" view --resume --frames 2 >out 2>err
    code=$?
    met view 0 "session.ini: no saved state: a fresh start" "view --resume, nothing kept"
    same "it says so in one line" "$(wc -l <err)" 1
    exits 2 "expected 1..16" view --scale 0
    exits 3 "No such file" view nowhere.ini
    exits 4 "no window can be opened" view minimal
    echo "; a scene" >my.ini
    exits 4 "draws a picture: tidepool render ./my.ini$" view ./my.ini
    SDL_VIDEODRIVER=x11
    export SDL_VIDEODRIVER
    exits 4 "no window can be opened" view minimal
    if lacks Xvfb xvfb "a display that is lost"; then
        echo "view 5" >>met
    else
        lose_display
        met view 5 "the display is lost" "view, whose display ends"
    fi
fi

# -- --help of each command -------------------------------------------------------------

for command in $("$program" --help | sed -n 's/^  \([a-z]*\) .*  .*/\1/p'); do
    said=$("$program" $command --help 2>/dev/null | sed -n 's/^Exit: //p' | tr , '\n' |
        awk -v name=$command '{ print name, $1 }')
    same "$command can exit with what its help says, and with nothing else" \
        "$(sort -u met | grep "^$command ")" "$said"
done
run --help
same "the program's help says what each code means" \
    "$(sed -n '/^Exit:/,$p' out | tr '\n' ' ' | tr -s ' ')" "Exit: 0 done, \
1 a check failed, 2 usage, 3 bad input, 4 no display or device, 5 display lost. "
exits 2 "COMMAND is missing"
exits 2 "no command" sail

# -- scripts ----------------------------------------------------------------------------

cd "$root" || exit 2
for script in run gallery board_steps tour setup web/pack; do
    "ports/$script.sh" >"$work/out" 2>"$work/err" </dev/null
    same "ports/$script.sh without arguments is a usage error" \
        "$? $(grep -c "ports/$script.sh" "$work/err")" "2 1"
done
serves() {      # CODE WORDS ARGUMENT...
    want=$1 words=$2
    shift 2
    timeout 20 node ports/web/serve.js "$@" >"$work/out" 2>"$work/err" </dev/null
    code=$?
    cd "$work" || exit 2
    judge "serve.js FOLDER ${2:-}: exit code $want" "$want" "$words"
    cd "$root" || exit 2
}
if command -v node >/dev/null; then
    serves 2 "^usage: node ports/web/serve.js" "$work" http
    serves 2 "^usage: node ports/web/serve.js" "$work" 70000
    serves 3 "no index.html; .make web. builds" "$work"
else
    skip "the page's server" "nodejs"
fi
cd "$work" || exit 2

finish
