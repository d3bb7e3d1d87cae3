#!/bin/sh
# SPDX-License-Identifier: MIT
# Files that replace others: two writers at once, every failing call, every signal that
# ends a program.  No content is lost or half written, and no temporary file is left.
#     saves.sh PROGRAM
build=$(realpath "${TP_BUILD:-build/host}") || exit 2
scene=$(realpath assets/scenes/pond.ini) || exit 2
small=$(realpath assets/scenes/minimal.ini) || exit 2
. "$(dirname "$0")/../lib/script.sh"
program_begin "$1"
saves=$build/tests/host/saves
faults=$build/faults.so

# nothing_left NAME: expects no temporary file in the current folder or below.
nothing_left() {
    same "$1: no temporary file is left" "$(find . -name '.tidepool-*')" ""
}

# -- two writers -----------------------------------------------------------------------

for kind in keep session scene picture; do
    mkdir two
    "$saves" $kind 1 two/$kind "$scene" >/dev/null
    "$saves" $kind 200 two/$kind "$scene" >one 2>err &
    "$saves" $kind 200 two/$kind "$scene" >other 2>>err &
    "$saves" -r $kind 100 two/$kind "$scene" >read 2>>err
    wait
    same "two writers, 400 times a $kind: none fails" "$(cat one other)" "0
0"
    same "and who reads finds a whole $kind each time" "$(cat read)" 0
    nothing_left "two writers of a $kind"
    rm -r two
done

# -- calls that fail -------------------------------------------------------------------

# Prints the fault after a run with exit code $code.  `old` has the files from before,
# `whole` those after success.
complaint() {   # FILE
    case $code in
    0) cmp -s "whole/$1" "new/$1" || echo "exit code 0, but another file" ;;
    3)
        cmp -s "old/$1" "new/$1" || echo "the old file is gone"
        [ "$(wc -l <err)" -eq 1 ] || echo "$(wc -l <err) lines: $(cat err)"
        [ $call != write ] || grep -q 'No space left on device$' err || cat err
        ;;
    *) echo "exit code $code" ;;
    esac
    ! grep leaked fault
    find . -name '.tidepool-*'
}

# Each call of a kind fails in turn, until the command makes no more such calls. After the
# first 40 only each seventh fails, but for a run with TP_SOAK.
failing() {     # NAME CALL FILE COMMAND...
    name=$1 call=$2 file=$3 at=0 runs=0 wrong=
    shift 3
    while [ -z "$wrong" ] && [ $at -lt 1000 ]; do
        step=1
        [ -n "${TP_SOAK:-}" ] || [ $at -lt 40 ] || step=7
        at=$((at + step))
        rm -rf new
        cp -r old new
        timeout 60 env FAULT_CALL=$call FAULT_AT=$at FAULT_LOG=fault LD_PRELOAD=$faults \
            "$@" >out 2>err </dev/null
        code=$?
        grep -q '^hit' fault || break
        runs=$((runs + 1))
        wrong=$(complaint "$file")
    done
    verdict "$name: $runs calls of $call fail in their turn, up to $((at - step))" \
        "${wrong:+call $at: $wrong}"
    [ $at -gt 1 ] || verdict "$name: there is a $call" "none"
}

# files FILE COMMAND...: makes `old` with the file to replace, and `whole` with the new
# one.
files() {
    rm -rf old new whole
    mkdir -p "old/$(dirname "$1")"
    echo old >"old/$1"
    cp -r old new
    shift
    "$@" >out 2>err
    mv new whole
}

for kind in keep scene picture session; do
    case $kind in
    session) file=session/tidepool/session.ini calls="open memory write fsync rename" ;;
    keep)    file=keep calls="open memory write fsync close rename" ;;
    *)       file=$kind calls="open memory stream write close rename" ;;
    esac
    files $file "$saves" $kind 1 new/$kind "$small"
    for call in $calls; do
        failing "a $kind" $call $file "$saves" $kind 1 new/$kind "$small"
    done
done
FAULT_MAIN=1
export FAULT_MAIN
set -- "$program" render "$small" --size 64x48 --frames 30 --out new/film.y4m
files film.y4m "$@"
for call in open stream write close rename; do
    failing "a film" $call film.y4m "$@"
done
set -- "$program" bake "$small" -o new/small.c
files small.c "$@"
for call in open stream write close rename; do
    failing "a baked scene" $call small.c "$@"
done
unset FAULT_MAIN
rm -rf old new whole

# -- signals ---------------------------------------------------------------------------

writes() { [ -n "$(find . -name '.tidepool-*')" ]; }
# All catchable signals that end a program; it ignores SIGPIPE and SIGXFSZ.
ulimit -c 0
for number in 1 2 3 4 5 6 7 8 10 11 12 14 15 16 24 26 27 29 30 31 34 64; do
    env --default-signal "$program" render "$scene" --size 64x48 --frames 1000000 \
        --out film.y4m >out 2>err &
    child=$!
    until_true writes
    kill -$number $child
    wait $child 2>/dev/null
    same "signal $number ends it" $? $((128 + number))
    nothing_left "signal $number"
done
same "and there is no film" "$(ls)" "$(ls | grep -v film)"

# -- full devices ----------------------------------------------------------------------

if [ -w /dev/full ]; then
    for command in scenes "params pond" "plan pond" manual "manual --scene" help \
            "completion bash" "render $scene --size 32x24 --hash --frames 900" \
            "render $scene --size 64x48 --frames 9 --out -" \
            "render $scene --size 64x48 --out /dev/full" "bake $scene -o /dev/full" \
            "bake $scene -o -"; do
        timeout 60 "$program" $command >/dev/full 2>err
        code=$?
        judge "$(echo "$command" | sed 's,/[^ ]*/,,'): a full device" 3 \
            ": No space left on device$"
        same "it is said once" "$(wc -l <err)" 1
    done
else
    echo "skipped: a full device (there is no /dev/full)"
fi
(
    ulimit -f 8                         # blocks of 512 or 1024 bytes; a world is 38 KB
    trap '' XFSZ
    "$saves" keep 1 large "$scene" >out 2>err
)
code=$?
judge "a world that is larger than a file may be" 3 "^large: cannot be saved: File too large$"
same "leaves nothing" "$(ls -A | grep large)" ""
nothing_left "a world that is too large"

finish
