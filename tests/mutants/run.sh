#!/bin/sh
# SPDX-License-Identifier: MIT
# Mutation test: breaks the core in random places, one at a time, and counts the mutants
# that tests detect.
#
#   tests/mutants/run.sh [N [SEED [FILE...]]]       100 mutants, seed 1, of the core
#
# sites.awk lists the places and the operators; all operators are equally likely. A mutant
# that does not compile, or compiles to the original's code, is replaced by another. Tests
# of the mutated file run first, then tests of its folder, the golden frames, and the
# rest, fast tests before slow ones; the first failing test kills the mutant. A test may
# take five times its usual processor time. With MUTANTS_MOST set, tests that usually take
# more seconds are left out; with MUTANTS_ONLY set, tests whose names do not match that
# grep pattern are left out.
#
# The mutants are made in a copy of the sources, in build/mutants. The tests are linked
# with the core as a shared library, so a mutant costs one compilation.
set -eu

count=${1:-100} seed=${2:-1}
[ $# -lt 2 ] && set -- || shift 2
[ $# -gt 0 ] || set -- $(find src -name "*.c" | sort)
here=$(pwd)/tests/mutants top=build/mutants tree=build/mutants/tree
export TP_SEED=1

# -- copy, build and timing ------------------------------------------------------------

mkdir -p $tree
find Makefile LICENSE README.md assets include ports src tests -type f >$top/files
while read -r file; do
    cmp -s "$file" "$tree/$file" && continue
    mkdir -p "$tree/$(dirname "$file")"
    cp "$file" "$tree/$file"
done <$top/files

core=build/mutants/libtidepool.so
in_tree()       # GOAL...
{
    env -u MAKEFLAGS -u MAKELEVEL -u MFLAGS make -s -C $tree --no-print-directory -j2 \
        TARGET=mutants V3_C= CHECKED=1 OPT='-O2 -fPIC' CFLAGS=-w LIB=$core "$@"
}

# passes TEST SECONDS: true if the test passes within that processor time.
passes()
{
    (cd $tree && ulimit -c 0 && ulimit -t "$2" && ulimit -v 8000000 &&
        exec timeout -k 5 $(($2 * 20)) "$1" >test.log 2>&1 </dev/null)
}

# timed TEST: true if the test passes; prints its name and its processor time in seconds,
# rounded up.
timed()
{
    (passes "$1" 900 && times) >$top/took || { cat $tree/test.log; return 1; }
    tail -n 1 $top/took | tr 'ms' '  ' | awk -v test="$1" '{
        print test, int($1 * 60 + $2 + $3 * 60 + $4 + 1) }'
}

echo "building the tests"
in_tree list-tests | grep -v = |
    grep -e "${MUTANTS_ONLY:-.}" | sed 's,^,build/mutants/,' >$top/tests
in_tree $core $(cat $top/tests) >$top/log 2>&1 || { tail $top/log; exit 1; }
# The times are valid while the sources do not change.
{ xargs cksum <$top/files; cat $top/tests; } | cksum >$top/sum.new
if ! cmp -s $top/sum.new $top/sum; then
    echo "timing them"
    while read -r test; do
        timed "$test" || { echo "$test fails without a mutant" >&2; exit 1; }
    done <$top/tests >$top/times
    mv $top/sum.new $top/sum
fi

# -- mutants ---------------------------------------------------------------------------

# order FILE: the tests to run, in the order described above.
order()
{
    unit=${1#src/}
    folder=${unit%%/*} unit=${unit##*/} unit=${unit%.*}
    awk -v own="/test_${folder}_$unit" -v folder="/test_${folder}_" \
        -v most="${MUTANTS_MOST:-9999}" '$2 <= most {
            rank = index($1, own) ? 1 : index($1, folder) ? 2 : $1 ~ /golden/ ? 3 : 4
            print rank, $2, $1 }' $top/times | sort -k1,1n -k2,2n | cut -d' ' -f2,3
}

# killer FILE: the test that detects the mutant, or nothing.
killer()
{
    order "$1" | while read -r seconds test; do
        passes "$test" $((seconds * 5 + 5)) || { echo "$test"; break; }
    done
}

tab=$(printf '\t')
awk -f "$here/sites.awk" "$@" | awk -v seed="$seed" -f "$here/pick.awk" |
    head -n $((count * 4)) >$top/picked
: >$top/verdicts
n=0
while IFS="$tab" read -r file line column length operator new; do
    [ $n -lt "$count" ] || break
    object=$tree/build/mutants/${file%.c}.o
    awk -v line="$line" -v column="$column" -v length_="$length" -v new="$new" \
        'FNR == line { $0 = substr($0, 1, column - 1) new substr($0, column + length_) }
         { print }' "$file" >"$tree/$file"
    cp -p "$object" $top/object
    if ! in_tree $core >$top/log 2>&1; then
        verdict=unbuilt by=
    elif cmp -s "$object" $top/object; then
        verdict=same by=
    else
        n=$((n + 1))
        by=$(killer "$file")
        verdict=${by:+killed}
        verdict=${verdict:-survived}
        echo "$n $verdict $file:$line:$column $operator -> $new  ${by##*/}"
        [ -n "$by" ] || sed -n "${line}s/^ */        /p" "$file"
    fi
    printf '%s\t%s\n' $verdict "$operator" >>$top/verdicts
    cp "$file" "$tree/$file"
    cp $top/object "$object"
done <$top/picked

awk -F'\t' '
    $1 == "same" || $1 == "unbuilt" { left_out[$1]++; next }
    { all[$2]++; killed[$2] += $1 == "killed"; n++; dead += $1 == "killed" }
    END {
        for (operator in all)
            printf "%-10s %3d of %3d killed\n", operator, killed[operator], all[operator]
        printf "%d of %d killed, %.0f %%; left out: %d of the same code, %d unbuilt\n",
            dead, n, n ? 100 * dead / n : 0, left_out["same"], left_out["unbuilt"]
    }' $top/verdicts
