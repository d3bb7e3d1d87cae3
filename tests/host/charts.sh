#!/bin/sh
# SPDX-License-Identifier: MIT
# tidepool charts on charts of the test, with jobs that print rows from files: order,
# fronts, failures.
#     charts.sh PROGRAM
. "$(dirname "$0")/../lib/script.sh"
program_begin "$1"

# -- a folder of charts, and a fake gnuplot that records its input ---------------------

mkdir charts rows bin
cat >bin/gnuplot <<'END'
#!/bin/sh
echo 'line 9: warning: Skipping data file with no valid points'
[ -z "${BAD_PICTURE:-}" ] || { echo "line 1: $BAD_PICTURE"; exit ${BAD_EXIT:-0}; }
eval "$(echo "$2" | sed "s/''/'\\\\''/g")"
echo "$2 $3 $4" >"$out.$term"
END
chmod +x bin/gnuplot
PATH=$work/bin:$PATH
mkdir tmp
TMPDIR=$work/tmp
export TMPDIR
cat >charts/demo.ini <<'END'
[chart]
title  = Demo: cost against error
keys   = method size
values = cost error
values = used
units  = cost:instructions error:m_of_height ms:ms
pareto = cost error
job    = cat rows/a
job    = cat rows/b
large  = cat rows/c
times  = ms
time   = cat rows/t
END
cat >charts/scenes.ini <<'END'
[chart]
title  = Scenes
keys   = scene
values = n
job    = echo scenes,{scene},n,1
END
echo "What to choose." >charts/demo.txt
echo "All scenes are one." >charts/scenes.txt
printf '# Page\n\n@sce*\n\n@nothing\n\n## More\n' >charts/page.md
: >charts/style.gp
echo '{ print "<" $0 ">" }' >charts/svg.awk
cat >rows/a <<'END'
demo,lin;8,cost,20
demo,lin;8,error,0.5
demo,lin;16,cost,30
demo,lin;16,error,0.25
demo,lin;8,used,-
END
cat >rows/b <<'END'
demo,a10;1,cost,9.5
demo,a9;1,cost,9
demo,a9;1,error,4
demo,a10;1,error,4
demo,lin;-2,cost,1e2

demo,lin;-2,error,1e-3
demo,lin;16,used,count-64 tank
demo,lin;8,cost,20
END
cat >rows/c <<'END'
demo,lin;2.5,cost,40
demo,lin;2.5,error,0.25
demo,lin;2.5,used,all
END
echo "demo,lin;8,ms,1.5" >rows/t
cat >wanted.csv <<'END'
method,size,cost,error,used,front
a9,1,9,4,,1
a10,1,9.5,4,,0
lin,-2,1e2,1e-3,,1
lin,2.5,40,0.25,all,0
lin,8,20,0.5,-,1
lin,16,30,0.25,count-64 tank,1
END

alike() {       # NAME FILE FILE
    verdict "$1" "$(cmp "$2" "$3" 2>&1)"
}
tables() {      # DIR: prints all tables, one after the other
    (cd "$1" && for table in *.csv; do echo "$table"; cat "$table"; done)
}
kept() {
    rm -rf build
}

# -- a whole sweep ----------------------------------------------------------------------

missing="chart demo: a9;1 has no used
chart demo: a10;1 has no used
chart demo: lin;-2 has no used"
expect "a sweep is made" 0 "has no used" charts whole --from charts
same "it says what is missing, and nothing else" "$(cat err)" "$missing"
alike "rows are sorted, numbers by size; the front is marked" wanted.csv whole/demo.csv
same "times have a table of their own" "$(cat whole/demo.time.csv)" "method,size,ms
lin,8,1.5"
same "{scene} is every shipped scene" "$(sed 1d whole/scenes.csv | LC_ALL=C sort)" \
    "$("$program" scenes | awk 'NF { print $1 ",1" }' | LC_ALL=C sort)"
same "pictures are drawn in both forms, and nothing else is there" \
    "$(ls -A whole | tr '\n' ' ')" "README.md demo.csv demo.png demo.svg demo.time.csv \
scenes.csv scenes.png scenes.svg "
same "gnuplot is told of files and form" "$(sed "s/out='[^']*tidepool-....../out='TEMPORARY/" \
    whole/demo.svg)" "<csv='whole/demo.csv'; \
time_csv='whole/demo.time.csv'; out='TEMPORARY/demo'; term='svg';  charts/style.gp \
charts/demo.gp>"
same "and draws in a folder that is gone then" "$(ls -A "$TMPDIR")" ""
same "the page has both charts, in its order" "$(grep '^#' whole/README.md)" "# Page
### Scenes
## More
### Demo: cost against error"
for words in "What to choose." '!\[Scenes\](scenes.png)' '(demo.time.csv)' '(demo.svg)' \
    '`tidepool charts DIR --only demo`' '`error` m of height'; do
    verdict "the page has $words" "$(grep -q -e "$words" whole/README.md || echo no)"
done
verdict "no two empty lines in it" "$(uniq -c whole/README.md | awk '$1 > 1 && NF == 1')"
run charts again --from charts --jobs 7
same "again, by more jobs: the same bytes" "$(tables again)" "$(tables whole)"
run charts "it's/a new one" --from charts
same "a folder of any name" "$code $(tables "it's/a new one")" "0 $(tables whole)"
verdict "with pictures" "$([ -s "it's/a new one/demo.png" ] || ls -A "it's/a new one")"

# -- in pieces --------------------------------------------------------------------------

run charts --list --from charts
cp out list
same "the list has every job, once" "$(sort -u list | wc -l) $(grep -c '^cat' list)" \
    "$(wc -l <list) 4"
for order in cat tac sort 'sort -r'; do
    $order list | while read -r job; do sh -c "$job"; done >all
    run charts --collect all pieces --from charts
    same "rows by \`$order\` of the jobs make the same tables" "$code $(tables pieces)" \
        "0 $(tables whole)"
done
awk '{ print (NR * 7919) % 101, $0 }' all | sort -n | cut -d' ' -f2- >mixed
split -l 9 mixed part.
"$program" charts --collect part.* - pieces --from charts <rows/a 2>err
same "in many files, some twice, one by a pipe" "$? $(tables pieces)" "0 $(tables whole)"
same "so is the page" "$(cat pieces/README.md)" "$(cat whole/README.md)"
run charts small --from charts --small
same "the small sweep is without large jobs and times" "$code $(ls small | grep -c csv) \
$(cut -d, -f1-5 small/demo.csv)" "0 2 $(cut -d, -f1-5 wanted.csv | grep -v 2.5)"
same "and has nothing to say, and draws nothing" "$(cat err; ls small | grep -e png)" ""
run charts --list --small --from charts --only demo
same "nor does it list them" "$(cat out)" "cat rows/a
cat rows/b"
run charts one --from charts --only demo
same "one chart alone" "$code $(cd one && echo *.csv)" "0 demo.csv demo.time.csv"

# -- the front --------------------------------------------------------------------------

mkdir fronts
cp charts/page.md charts/style.gp charts/svg.awk fronts
cat >fronts/cloud.ini <<'END'
[chart]
title  = Cloud
keys   = g n
values = a b
pareto = a b
group  = g
job    = cat rows/cloud
END
echo text >fronts/cloud.txt
awk 'BEGIN {
    srand(7)
    for (i = 0; i < 300; i++) {
        g = i % 3 ? "left" : "right"
        if (i % 17) printf "cloud,%s;%d,a,%d\n", g, i, 40 * rand()
        if (i % 19) printf "cloud,%s;%d,b,%.2f\n", g, i, 4 * rand() * rand() - 1
    }
}' >rows/cloud
front() {       # OPTION: 1 by groups, 0 over all
    awk -F, -v groups="$1" 'NR > 1 { g[NR] = $1; a[NR] = $3; b[NR] = $4; line[NR] = $0 }
    END {
        for (i = 2; i <= NR; i++) {
            best = a[i] != "" && b[i] != ""
            for (k = 2; k <= NR; k++)
                if (a[k] != "" && b[k] != "" && (!groups || g[i] == g[k]) &&
                    a[k] + 0 <= a[i] + 0 && b[k] + 0 <= b[i] + 0 &&
                    (a[k] + 0 < a[i] + 0 || b[k] + 0 < b[i] + 0))
                    best = 0
            found += best
            sub(/,[01]$/, "," best, line[i])
            print line[i]
        }
        if (found < 4) print "a front of " found
    }' cloud/cloud.csv
}
run charts cloud --from fronts
same "a front for each group is as by brute force" "$(sed 1d cloud/cloud.csv)" "$(front 1)"
sed -i '/^group/d' fronts/cloud.ini
run charts cloud --from fronts
same "and one over all" "$(sed 1d cloud/cloud.csv)" "$(front 0)"
sed -i '/^pareto/d' fronts/cloud.ini
run charts cloud --from fronts
same "without pareto there is no such column" "$(head -1 cloud/cloud.csv)" "g,n,a,b"

# -- faults -----------------------------------------------------------------------------

tables whole >before
cp rows/b b.good
cp charts/demo.ini ini.good
echo "cat rows/b >&2; echo alas >&2; exit 5" >rows/b
sed -i 's,cat rows/b,sh rows/b,' charts/demo.ini
kept
expect "a job that fails is shown" 1 "^tidepool charts: exit 5: sh rows/b$" \
    charts whole --from charts
verdict "with what it said" "$(grep -q '^    | alas$' err || cat err)"
same "its chart stays as it was, the others are written" "$(tables whole)" \
    "$(cat before)"
rm whole/demo.csv whole/scenes.csv
run charts whole --from charts
same "so a new one is not there" "$code $(cd whole && ls *s.csv demo.csv 2>/dev/null)" \
    "1 scenes.csv"
verdict "and no half of anything" "$(find . -name '*.part' -o -name '.tidepool*' \
    -o -name '.demo*')"
echo 'kill -9 $PPID' >rows/b
expect "a job that is killed" 1 "^tidepool charts: signal 9: sh rows/b$" \
    charts whole --from charts
: >rows/b
expect "a job without a word" 3 "^sh rows/b: no rows$" charts whole --from charts
cp ini.good charts/demo.ini
run charts whole --from charts          # rows/b is empty still
cp b.good rows/b

bad() {         # NAME PATTERN ROW
    printf '%s\n' "demo,x;1,cost,1" "$3" >rows/b
    rm -rf bad
    expect "$1" 3 "^cat rows/b:2: $2" charts bad --from charts
    verdict "$1: no table of it" "$(ls bad/demo.csv 2>/dev/null)"
    expect "$1, collected" 3 "^rows/b:2: $2" charts --collect rows/b bad --from charts
    verdict "$1: no table at all" "$(ls bad/*.csv 2>/dev/null | grep -v scenes)"
}
row="expected CHART,KEYS,COLUMN,VALUE, found"
bad "a row of three fields" "$row demo,x;1,cost$" "demo,x;1,cost"
bad "a row of five" "$row demo,x;1,cost,1,2$" "demo,x;1,cost,1,2"
bad "an empty value" "$row" "demo,x;1,cost,"
bad "an empty column" "$row" "demo,x;1,,1"
bad "quotes" "$row" 'demo,"x";1,cost,1'
bad "words" "$row" "measuring..."
bad "an unknown chart" "no chart demi; did you mean demo?" "demi,x;1,cost,1"
bad "an unknown column" "no column costs; did you mean cost?" "demo,x;1,costs,1"
bad "a key as a column" "no column method" "demo,x;1,method,1"
bad "our own column" "no column front" "demo,x;1,front,1"
bad "a key too few" "x for keys; chart demo has 2" "demo,x,cost,1"
bad "a key too many" "x;1;2 for keys; chart demo has 2" "demo,x;1;2,cost,1"
bad "an empty key" "x; for keys" "demo,x;,cost,1"
printf 'demo,x;1,cost,1\ndemo,x\0;1,cost,1\n' >rows/b
expect "a zero byte" 3 "rows/b:2: a zero byte" charts --collect rows/b bad --from charts
only_direct() { # NAME PATTERN ROW: rows that only a job's own list forbids
    printf '%s\n' "$3" >rows/b
    expect "$1" 3 "$2" charts bad --from charts
}
only_direct "rows of another chart" ":1: the job does not belong to chart scenes" \
    "scenes,x,n,1"
only_direct "a time of a job that is none" "only a .time. job prints times: ms" \
    "demo,x;1,ms,1"
cp b.good rows/b
cp rows/t t.good
echo "demo,x;1,cost,1" >rows/t
expect "a value of a time job" 3 "a .time. job prints only times: cost" charts bad \
    --from charts
cp t.good rows/t
echo "demo,lin;8,cost,21" >rows/c
kept
expect "two values for one cell" 3 \
    "^cat rows/c:1: chart demo: cost of lin;8 is 21; cat rows/[ab]:[19] has 20$" \
    charts bad --from charts
echo "demo,lin;2.5,cost,cheap" >rows/c
expect "a word on a front" 3 "chart demo: cost of lin;2.5 is cheap; a front takes" \
    charts bad --from charts
printf 'demo,lin;2.5,%s\n' cost,40 error,0.25 used,all >rows/c

expect "a folder that cannot be" 3 "^rows/a/x: Not a directory$" charts rows/a/x \
    --from charts
expect "a file for a folder" 3 "^rows/a: Not a directory$" charts rows/a --from charts
expect "a file of rows that is not there" 3 "^nowhere: No such file" charts --collect \
    nowhere bad --from charts
expect "no project here" 3 "run it in the project's folder$" charts bad
expect "nor for the list" 3 "run it in the project's folder$" charts --list
expect "a folder without charts" 3 "rows: no chart in this folder" charts bad \
    --from rows
expect "an unknown chart is asked for" 2 "no chart dem; did you mean demo?" charts bad \
    --from charts --only scenes,dem
expect "no folder" 2 "DIR is missing" charts
expect "no files" 2 "needs FILE and DIR" charts --collect bad
expect "two folders" 2 "too many names" charts one two
expect "a folder for the list" 2 "too many names" charts --list one
expect "list and collect" 2 "exclude each other" charts --list --collect a b
expect "no jobs at a time" 2 "1..1024" charts bad --jobs 0

ini() {         # NAME PATTERN SCRIPT: sed's, on demo.ini
    sed "$3" ini.good >charts/demo.ini
    expect "$1" 3 "^charts/demo.ini:$2" charts bad --from charts
}
ini "a name that is none" "4: nothing is called value; did you mean values?" \
    '4s/values/value /'
ini "a section that is none" "2: \[charts\]; expected \[chart\]" '1s/t]/ts]/'
ini "no name at all" "3: neither" '3s/=//'
ini "two titles" "3: title: twice" '2p'
ini "an empty list" "3: keys: empty" '3s/=.*/=/'
ini "no title" " a chart needs title, keys and values" '2d'
ini "no keys" " a chart needs title, keys and values" '3d'
ini "no job" " no job" '/cat rows.[abc]/d'
ini "a front of one value" " pareto: expected two values" 's/cost error$/cost/;5!b'
ini "a front of no value" " pareto: no value is called ms" '/pareto/s/error/ms/'
ini "a group that is no key" " group: no key is called cost" '/pareto/s/$/\ngroup=cost/'
ini "a sparse key" " sparse: no value is called size" '/pareto/s/$/\nsparse=used size/'
ini "a unit of nothing" " units: no value is called errors" 's/error:/errors:/'
ini "a unit without one" " units: expected COLUMN:UNIT, found ms" 's/ms:ms/ms/'
ini "times without a job" " times (columns) and time (a command) go" '/^time /d'
ini "a job without times" " times (columns) and time (a command) go" '/^times/d'
ini "a column twice" " two columns are called size" '/used/s/used/used size/'
ini "a column that reads as a note" " a column cannot be called #" '/^keys/s/= */= #/'
ini "a column of ours" " two columns are called front" '/used/s/used/front/'
sed '/pareto/s/$/\nsparse = used/' ini.good >charts/demo.ini
expect "what may be missing is not told of" 0 "" charts sparse --from charts
alike "and changes nothing" wanted.csv sparse/demo.csv
cp ini.good charts/demo.ini

# -- pictures ---------------------------------------------------------------------------

rm -rf whole
export BAD_PICTURE="undefined variable: x"
for BAD_EXIT in 0 1; do
    export BAD_EXIT
    expect "a picture that gnuplot complains of, exit $BAD_EXIT" 1 \
        "    | line 1: undefined variable: x" charts whole --from charts
done
verdict "it is called by its title" "$(grep -q 'exit 1: Scenes$' err || cat err)"
unset BAD_PICTURE
same "tables are there, pictures are not" "$(ls -A whole | tr '\n' ' ')" \
    "README.md demo.csv demo.time.csv scenes.csv "
same "nor anything of them elsewhere" "$(ls -A "$TMPDIR")" ""

TMPDIR=$work/nowhere
expect "without a place for pictures there are none" 3 "nowhere/tidepool-.*: No such file" \
    charts whole --from charts --only demo
TMPDIR=$work/tmp
mkdir tools
for tool in sh cat timeout env; do ln -s "$(command -v $tool)" tools/; done
rm -rf whole
(PATH=$work/tools && run charts whole --from charts && exit $code)
code=$?
judge "without gnuplot there are tables" 0 "package gnuplot-nox"
same "and the page" "$(ls -A whole | tr '\n' ' ')" \
    "README.md demo.csv demo.time.csv scenes.csv "
verdict "which then links to no picture" "$(grep -e png -e svg whole/README.md)"
rm charts/demo.txt
expect "a chart without a text" 0 "chart demo: no text (charts/demo.txt)" charts whole \
    --from charts
finish
