#!/bin/sh
# SPDX-License-Identifier: MIT
# tidepool check: the shipped tables hold, and a fault in a table or in a scene is reported
# with file and line; old names of parameters are rewritten in place.
#     check.sh PROGRAM
. "$(dirname "$0")/../lib/script.sh"
program_begin "$1"
limit=300

# folder FILE...: makes a new folder t with copies of tables.
folder() {
    rm -rf t
    mkdir t
    for file; do cp "$vectors/$file.csv" t; done
}

# broken NAME PATTERN FILE SCRIPT: a table changed by a sed script is refused.
broken() {
    folder "$3"
    sed -e "$4" "$vectors/$3.csv" >"t/$3.csv"
    expect "$1" 3 "$2" check --vectors t
}

# -- the shipped tables ----------------------------------------------------------------

expect "all shipped tables hold" 0 "" check --vectors "$vectors"
for file in "$vectors"/*.csv; do
    name=$(basename "$file" .csv)
    verdict "$name is in the table" "$(grep -q "^$name .* ok$" out || echo "it is not")"
done
verdict "no line says otherwise" "$(grep -v -e ' ok$' -e '^file' out)"
verdict "the table fits 80 columns" "$(awk 'length($0) > 80' out)"
rows=$(grep -vc -e '^#' "$vectors/sine.csv")
verdict "every row is counted" \
    "$(awk -v rows="$rows" '/^sine +sine  / && $3 != rows - 1' out)"

folder fresnel exposure
expect "a folder may hold some tables" 0 "" check --vectors t
touch t/README t/notes.txt t/.hidden.csv
expect "other files and hidden ones are passed over" 0 "" check "--vectors=t"
sed -i 's/$/\r/' t/fresnel.csv
expect "lines may end as elsewhere" 0 "" check --vectors t

# -- errors above the limit -------------------------------------------------------------

folder fresnel exposure
sed -i '8s/,[^,]*$/,0.5/' t/fresnel.csv
expect "a wrong value is found" 1 "t/fresnel.csv:8: Schlick is off by" check --vectors t
verdict "the table says so" "$(grep -q 'OVER' out || echo "it does not")"
verdict "and goes on with other tables" "$(grep -q '^fresnel .* ok$' out || echo no)"
sed -i '8d' t/exposure.csv
expect "a bad table counts more than a wrong value" 3 "t/exposure.csv:8: tick 6; expected 5" \
    check --vectors t
verdict "the other is judged all the same" "$(grep -q 'OVER' out || echo "it is not")"
folder automaton_int
sed -i '5s/[0-9]*$/1/' t/automaton_int.csv
expect "a wrong CRC is found" 1 "t/automaton_int.csv:5: crc32 is off" check --vectors t
mode_at()       # HEIGHT: height of the first mode, by the scheme of 8 and 16 bits
{
    folder automaton_mode
    awk -F, -v OFS=, -v height="$1" 'NR == 3 { $10 = height } { print }' \
        "$vectors/automaton_mode.csv" >t/automaton_mode.csv
}
mode_at -1.0008
expect "a mode may swing below -1" 1 "t/automaton_mode.csv:3: .*is off by" \
    check --vectors t
mode_at 1.4143
expect "no mode swings to the root of 2" 3 "t/automaton_mode.csv:3: H_discrete" \
    check --vectors t
folder buoyancy
awk -F, -v OFS=, '/^[-0-9]/ { $8 = $6 } { print }' "$vectors/buoyancy.csv" >t/buoyancy.csv
expect "a step is compared with itself, not with the root" 1 "step 1 is off" \
    check --vectors t

# -- bad tables ------------------------------------------------------------------------

folder sine
mv t/sine.csv t/sines.csv
expect "an unknown name" 3 "t/sines.csv: no model has this name; did you mean sine.csv?" \
    check --vectors t
mv t/sines.csv t/something_else.csv
expect "a name far from all" 3 "t/something_else.csv: no model has this name$" \
    check --vectors t
broken "an unknown column" "t/sine.csv:2: unknown column 'sinn'; did you mean sin?" sine \
    '2s/,sin,/,sinn,/'
broken "a column twice" "t/sine.csv:2: column 'sin' twice" sine '2s/,cos,/,sin,/'
broken "a column that is missing" "t/sine.csv:2: no column 'cos_q16'" sine \
    '2,$s/,[^,]*$//'
broken "a column more" "t/sine.csv:2: unknown column 'extra'" sine \
    '2s/$/,extra/;3,$s/$/,0/'
broken "no rows" "t/sine.csv:2: no rows" sine '3,$d'
broken "no column names" "t/sine.csv:2: no column names" sine '2,$d'
broken "nothing at all" "t/sine.csv:1: no column names" sine d
broken "a word for a number" "t/sine.csv:4: sin: expected a number, found 'much'" sine \
    '4s/,[^,]*,/,much,/'
broken "a number with a tail" "sine.csv:4: sin: expected a number, found '0.5x'" sine \
    '4s/,[^,]*,/,0.5x,/'
for bad in nan inf 0x10 1e999 "" " 1" 1..2 -; do
    broken "the number '$bad'" "sine.csv:4: sin: expected a number, found '$bad'" sine \
        "4s/,[^,]*,/,$bad,/"
done
broken "a field less" "t/sine.csv:4: 4 fields; there are 5 columns" sine '4s/,[^,]*$//'
broken "a field more" "t/sine.csv:4: 6 fields; there are 5 columns" sine '4s/$/,0/'
broken "an empty line" "t/sine.csv:4: 0 fields; there are 5 columns" sine '4s/.*//'
broken "a number beyond its range" "t/sine.csv:4: sin = 1.5 is outside -1..1" sine \
    '4s/,[^,]*,/,1.5,/'
broken "a fraction where there is none" "phase_u32 = 0.5 .* or not a whole number" sine \
    '4s/^[^,]*/0.5/'
broken "an unknown word" "dispersion.csv:3: class = 'wet' is none of shallow|" dispersion \
    '3s/[a-z]*$/wet/'
broken "an unknown parameter line" "sine.csv:2: unknown parameter line 'seed=5'" sine \
    '1a # seed=5'
broken "a parameter line that says something else" "time_scale.csv:1: unknown param" \
    time_scale '1s/tau=0.4/tau=0.5/'
broken "a parameter line with a bad number" "exposure.csv:1: unknown parameter line" \
    exposure '1s/e0=1/e0=x/'
broken "a parameter beyond its range" "exposure.csv:1: e0 = 99 is outside 0.125..8" \
    exposure '1s/e0=1/e0=99/'
broken "a parameter line that is missing" "sine.csv:1: no parameter line '# \[G1\]" sine 1d
broken "a parameter line twice" "sine.csv:2: too many parameter lines of this kind" \
    sine '1{p}'
broken "waves out of their order" "gerstner_sum.csv:3: number 2; expected 1" gerstner_sum \
    '3s/wave 1/wave 2/'
broken "a bad list of cells" "automaton_int.csv:3: init: expected INDEX:HEIGHT" \
    automaton_int '3s/,5:113;/,5:;/'
broken "a cell outside of the pool" "automaton_int.csv:3: init: expected INDEX:HEIGHT" \
    automaton_int '3s/,5:113;/,500:113;/'
broken "a step back" "automaton_int.csv:4: step 1 after step 1" automaton_int \
    '4s/,2,A,/,1,A,/'
broken "a pool that the core refuses" "no pool of .* can be made" automaton_mode \
    's/,0.234375,0.0625,/,0.25,0.0625,/'
folder sine
printf 'a\0b\n' >>t/sine.csv
expect "a zero byte" 3 "t/sine.csv: contains a zero byte" check --vectors t
mkdir t/fresnel.csv
expect "a folder for a table" 3 "t/fresnel.csv: Is a directory" check --vectors t

# -- scenes ----------------------------------------------------------------------------

# scene LINE...: writes lake.ini.
scene() { printf '%s\n' "$@" >lake.ini; }

for shipped in "$root"/assets/scenes/*.ini; do
    stem=$(basename "$shipped" .ini)
    expect "$stem is without a fault" 0 "" check "$stem"
    verdict "the values of $stem are counted" \
        "$(grep -q "/$stem.ini: [1-9][0-9]* values, no fault$" out || cat out)"
done
expect "a scene that is not there" 3 "^stormy: no such scene or file" check stormy
expect "a path that is not there" 3 "^no/lake.ini: No such file" check no/lake.ini
scene "[camera]" "x = 1" "y = wide" "zz = 4" "[wave0]" "steepness = 7"
expect "all bad lines are found" 3 "^lake.ini:3: camera.y: expected a number" check lake.ini
same "each in its line" "$(cut -d: -f2 err | tr '\n' ' ')" "3 4 6 "
scene "[camera]" "x = 1" "y ="
expect "a line without a value" 3 "^lake.ini:3: camera.y" check lake.ini
scene "[layer0]" "texture = none.png"
expect "a picture that is not there" 3 "^lake.ini:2: layer0.texture: .*none.png: No such" \
    check lake.ini
scene "[pool]" "cols = 32" "courant = 0.6"
expect "numbers that make no world" 3 "^lake.ini:3: pool.courant of 0.600 is above" \
    check lake.ini

# -- old names in scenes ---------------------------------------------------------------

# old: writes lake.ini with four old names, and the file `new` with the new ones.
old()
{
    scene "; pool.poke = 1 is a comment" "[scene]" "title=Lake ; feed = it" "shows = feed" \
        "" "[pool]" "  cols=32" "rows = 32" "  poke : 0.25   ; poke = high" "poke_size=1" \
        "feed_low = 0" "# the end"
    sed -e 's/^shows/description/' -e 's/^  poke :/  splash_height :/' \
        -e 's/^poke_size/splash_width/' -e 's/^feed_low/drive_min/' lake.ini >new
}
old
cp lake.ini before
expect "old names are faults" 1 \
    "^lake.ini:9: pool.poke is now called pool.splash_height$" check lake.ini
same "each in its line" "$(sed -n 's/^lake.ini:\([0-9]*\): .*/\1/p' err | tr '\n' ' ')" \
    "4 9 10 11 "
verdict "the last line says how to rewrite them" "$(tail -1 err | grep -v \
    '^lake.ini: old names are read until version .*`tidepool check lake.ini --write`')"
same "the file stays" "$(cmp lake.ini before)" ""
chmod 640 lake.ini
expect "--write rewrites them" 0 "" check lake.ini --write
same "and keeps all else" "$(cmp lake.ini new)" ""
same "and the file's mode" "$(stat -c %a lake.ini)" 640
same "and says what it changed" "$(head -2 out | tail -1)" \
    "lake.ini:9: pool.poke is now pool.splash_height"
touch -d 2001-01-01 lake.ini
expect "a second time there is nothing to write" 0 "" check lake.ini --write
same "the file is not touched" "$(date -r lake.ini +%Y) $(cmp lake.ini new)" "2001 "
same "it only says so" "$(cat out)" "lake.ini: 7 values, no fault"
old
sed -i 's/$/\r/' lake.ini new
expect "lines with other ends are rewritten" 0 "" check lake.ini --write
same "with the same ends" "$(cmp lake.ini new)" ""
old
printf '[grid]\nvertices = 99' | tee -a new >>lake.ini
ln -s lake.ini link.ini
expect "a file behind a link" 0 "" check --write ./link.ini
same "is rewritten, the link stays" "$(cmp lake.ini new) $(readlink link.ini)" " lake.ini"
grid() { printf '%s\n' "[grid]" "$@" "[wave0]" "amplitude = 0.5" >grid.ini; }
grid "cols = 64 ; wide" "rows=64" "follow = off"
expect "rows of the older grid are faults" 1 \
    "^grid.ini:2: grid.vertices = 1365 replaces the rows of the older grid$" check grid.ini
expect "and become vertices" 0 "" check grid.ini --write
same "in their section, comments stay" "$(tr '\n' '|' <grid.ini)" \
    "[grid]|; wide|vertices = 1365|[wave0]|amplitude = 0.5|"
expect "once" 0 "" check grid.ini
grid "cols = 1"
expect "a column is no grid" 3 "^grid.ini:2: grid.cols = 1 is outside 2..1024$" check grid.ini
old
echo "y = 1" >>lake.ini
cp lake.ini before
expect "a file with another bad line" 3 "^lake.ini:13: no parameter is called pool.y; " \
    check lake.ini --write
same "stays as it is" "$(cmp lake.ini before)" ""
old
echo "mask = none.png" | tee -a new >>lake.ini
expect "a file that names no picture" 3 "none.png: No such file" check lake.ini --write
same "is rewritten all the same" "$(cmp lake.ini new)" ""
old
i=0
while [ $((i += 1)) -le 400 ]; do echo "# comment"; done >>lake.ini
cp lake.ini before
(ulimit -f 1; timeout 60 "$program" check lake.ini --write >out 2>err)
code=$?
judge "no room for the new file" 3 "^lake.ini: File too large"
same "leaves the old one" "$(cmp lake.ini before) $(ls -A | grep -c 'lake.ini')" " 1"
same "and reports no change" "$(cat out)" ""
rm link.ini

# -- command lines ---------------------------------------------------------------------

mkdir empty
expect "a folder without tables" 3 "empty: no .csv file there" check --vectors empty
expect "a folder that is not there" 3 "nowhere: No such file" check --vectors nowhere
touch README
expect "a file for a folder" 3 "README: Not a directory" check --vectors README
expect "no folder" 2 "--vectors DIR is missing" check
expect "an empty name" 2 "expected a folder" check --vectors ""
expect "a scene and a folder" 2 "SCENE and --vectors exclude each other" \
    check three-swells --vectors empty
expect "two scenes" 2 "too many names: storm" check three-swells storm
expect "names to write in tables" 2 "--write and --vectors exclude" check --write \
    --vectors empty
expect "nothing to write in" 2 "SCENE or --vectors DIR is missing" check --write
expect "an option of another command" 2 "no option --hash" check --hash
expect "a misspelt option" 2 "did you mean --vectors?" check --vector empty
finish
