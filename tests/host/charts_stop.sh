#!/bin/sh
# SPDX-License-Identifier: MIT
# tidepool charts stopped by every signal that ends a program, while running jobs and
# while drawing.  The jobs end too, no half-written file is left, and --resume continues.
#     charts_stop.sh PROGRAM
. "$(dirname "$0")/../lib/script.sh"
program_begin "$1"

mkdir charts bin tmp
cat >bin/gnuplot <<'END'
#!/bin/sh
eval "$2"
echo "$term" >"$out.$term"
[ -z "${SLOW_PICTURE:-}" ] || { echo "$out" >>drawing; eval "$SLOW_PICTURE"; }
END
chmod +x bin/gnuplot
PATH=$work/bin:$PATH TMPDIR=$work/tmp
export TMPDIR
for name in one two; do
    echo text >charts/$name.txt
    printf '[chart]\ntitle = %s\nkeys = n\nvalues = v\njob = echo %s,1,v,2\n' $name \
        $name >charts/$name.ini
done
echo '# Page' >charts/page.md
: >charts/style.gp
echo '{ print "<" $0 ">" }' >charts/svg.awk

naps=321.$$                             # a time used by this test only
napping() {
    cat /proc/[0-9]*/cmdline 2>/dev/null | tr '\0' ' ' | grep -q "[s]leep $naps "
}
nobody_naps() {                         # signals need a moment
    for wait in $(seq 50); do
        napping || return 0
        sleep 0.1
    done
    echo "a job goes on"
}
left() { ls -A whole tmp | tr '\n' ' '; }

# -- while drawing ----------------------------------------------------------------------

export SLOW_PICTURE="sleep $naps"
for signal in HUP TERM USR1 USR2 ALRM XCPU; do
    rm -rf whole drawing
    "$program" charts whole --from charts --jobs 2 >out 2>err &
    pid=$!
    for wait in $(seq 200); do
        [ "$(grep -c . drawing 2>/dev/null)" = 2 ] && break
        sleep 0.05
    done
    kill -$signal $pid
    { wait $pid; } 2>/dev/null
    same "SIG$signal ends a sweep that draws, which says so" \
        "$(kill -l $?) $(grep -c 'stopped after 0 of 2 pictures' err)" "$signal 1"
    same "SIG$signal: there are tables, and nothing half made" "$(left)" \
        "tmp:  whole: one.csv two.csv "
    verdict "SIG$signal: its jobs end" "$(nobody_naps)"
done
for signal in INT QUIT; do              # ignored by background jobs of a shell
    rm -rf whole drawing
    timeout --preserve-status -s $signal 1 "$program" charts whole --from charts \
        --jobs 2 >out 2>err
    same "SIG$signal: nothing half made" "$(kill -l $?) $(left)" \
        "$signal tmp:  whole: one.csv two.csv "
    verdict "SIG$signal: its jobs end" "$(nobody_naps)"
done
SLOW_PICTURE="trap '' TERM; sleep $naps; sleep $naps"
rm -rf whole drawing
timeout --preserve-status -s HUP 1 "$program" charts whole --from charts >out 2>err
same "jobs that will not end: nothing half made" "$(kill -l $?) $(left)" \
    "HUP tmp:  whole: one.csv two.csv "
verdict "they are killed" "$(nobody_naps)"
SLOW_PICTURE='kill -9 $$'
rm -rf whole
expect "a gnuplot that is killed" 1 "exit 1: one$" charts whole --from charts
same "it leaves nothing half made" "$(left)" "tmp:  whole: README.md one.csv two.csv "
unset SLOW_PICTURE
run charts whole --from charts
same "then all of it is there" "$code $(left)" \
    "0 tmp:  whole: README.md one.csv one.png one.svg two.csv two.png two.svg "

# -- while running jobs -----------------------------------------------------------------

mkdir slow
cp charts/page.md charts/style.gp charts/svg.awk slow
cat >slow/slow.ini <<'END'
[chart]
title  = Slow
keys   = n
values = v
job    = echo 1 >>ran; echo slow,1,v,1
job    = echo 2 >>ran; echo slow,2,v,1
job    = echo 3 >>ran; [ -e go ] || sleep NAPS; echo slow,3,v,1
job    = echo 4 >>ran; echo slow,4,v,1
END
sed -i "s/NAPS/$naps/" slow/slow.ini
echo text >slow/slow.txt
for signal in 1 15; do
    rm -rf ran kept build slowly
    "$program" charts slowly --from slow --jobs 1 >out 2>err &
    pid=$!
    for wait in $(seq 100); do
        [ "$(grep -c . ran 2>/dev/null)" = 3 ] && break
        sleep 0.1
    done
    kill -$signal $pid
    { wait $pid; } 2>/dev/null
    same "stopped by signal $signal" "$? $(cat err)" "$((128 + signal)) tidepool charts: \
stopped after 2 of 4 jobs; --resume continues"
    same "nothing is written, two jobs are kept" "$(ls -A slowly) $(ls build/charts/rows |
        grep -c 'rows$') $(find build -name '*.part')" " 2 "
done
verdict "and nobody sleeps on" "$(nobody_naps)"
: >go
run charts slowly --from slow --resume --jobs 1
same "it goes on with the other two" "$code $(tr '\n' ' ' <ran)" "0 1 2 3 3 4 "
same "and says what it has" "$(cat err)" "tidepool charts: 2 of 4 jobs are done"
same "all rows are there" "$(tr '\n' ' ' <slowly/slow.csv)" "n,v 1,1 2,1 3,1 4,1 "
run charts slowly --from slow --resume --jobs 1
same "then all are kept" "$(cat err) $(wc -l <ran)" \
    "tidepool charts: 4 of 4 jobs are done 5"
mkdir -p build/host
: >build/host/tidepool
touch -d '+1 minute' build/host/tidepool
run charts slowly --from slow --resume --jobs 1
same "but not beyond another build of what measures" "$(cat err) $(wc -l <ran)" \
    "tidepool charts: 0 of 4 jobs are done
tidepool charts: 4 jobs of older tools run again 9"
rm build/host/tidepool
run charts slowly --from slow
same "nor without --resume" "$code $(wc -l <ran)" "0 13"
"$program" charts --collect build/charts/rows/*.rows pieces --from slow 2>err
same "kept rows can be collected" "$(cmp slowly/slow.csv pieces/slow.csv 2>&1)" ""
finish
