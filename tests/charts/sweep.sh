#!/bin/sh
# SPDX-License-Identifier: MIT
# The shipped charts are complete, and a small sweep gives the same counts on the Cortex-M4
# and the same errors, cell by cell.  Counts of x86-64 depend on this machine's compiler:
# they are not compared, nor are times.  With TP_SOAK set the charts of the plan are made
# whole.
#     sweep.sh PROGRAM
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/board.sh"

program=${1:-build/host/tidepool}
shipped=assets/charts

# -- files ------------------------------------------------------------------------------

whole()         # CHART: its description, drawing, text, table and pictures
{
    for file in "tests/charts/$1.gp" "tests/charts/$1.txt" $shipped/"$1.csv" \
        $shipped/"$1.png" $shipped/"$1.svg"; do
        [ -s "$file" ] || { echo "there is no $file"; return 1; }
    done
    grep -qF "($1.png)" $shipped/README.md || { echo "the page lacks it"; return 1; }
}
explained()     # CHART: its text names each shipped method that another one dominates
{
    awk -F, -v keys="$(awk '$1 == "keys" { n += NF - 2 } END { print n }' \
        "tests/charts/$1.ini")" '
        FILENAME ~ /txt$/ { text = text " " $0; next }
        FNR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
        at["front"] && at["used"] && $at["front"] == "0" && $at["used"] ~ /[a-z]/ {
            said = 0
            for (i = 1; i <= keys; i++)
                said = said || ($i ~ /[a-z0-9]/ && index(text, $i))
            if (!said) {
                print "the text does not name " $1 " " $2 " " $3
                bad = 1
            }
        }
        END { exit bad }' "tests/charts/$1.txt" $shipped/"$1.csv"
}
described()     # no table without its chart
{
    for table in $shipped/*.csv; do
        [ -e "$table" ] || { echo "there is no table at all"; return 1; }
        of=$(basename "${table%.time.csv}" .csv)
        [ -s "tests/charts/$of.ini" ] || { echo "$table is of no chart"; return 1; }
    done
}
light()         # pictures are small enough for a page
{
    find $shipped -name '*.png' -size +200k -o -name '*.svg' -size +1000k | grep . && return 1
    return 0
}
charts=
for chart in tests/charts/*.ini; do
    chart=$(basename "$chart" .ini)
    charts="$charts $chart"
    check "$chart has all that belongs to it" whole "$chart"
    check "$chart: its text names dominated shipped methods" explained "$chart"
done
check "every table has its chart" described
check "no picture is heavy" light
check "the table that opens the page has the measured figures" tests/charts/choices.sh

drawn()         # CHART: gnuplot draws its table without a message
{
    for term in png svg; do
        gnuplot -e "csv='$shipped/$1.csv'; time_csv='$shipped/$1.time.csv'" \
            -e "out='$scratch/$1'; term='$term'" tests/charts/style.gp \
            "tests/charts/$1.gp" 2>&1 | grep -v 'Skipping data file with no valid points' &&
            return 1
        [ -s "$scratch/$1.$term" ] || return 1
    done
}
if ! lacks gnuplot gnuplot-nox "drawing the charts"; then
    for chart in $charts; do
        check "$chart is drawn" drawn "$chart"
    done
fi

# -- a small sweep ----------------------------------------------------------------------

for tool in arm-none-eabi-gcc:gcc-arm-none-eabi qemu-system-arm:qemu-system-arm \
    qemu-x86_64:qemu-user valgrind:valgrind; do
    lacks "${tool%:*}" "${tool#*:}" "a small sweep of the charts" && {
        finish
        exit
    }
done
skip=
pinned tests/budgets/scenes.csv m4 arm-none-eabi-gcc || skip=m4

# same CHART: each row of the small sweep is in the shipped table, with the same values.
same()
{
    keys=$(awk '$1 == "keys" { n += NF - 2 } END { print n }' "tests/charts/$1.ini")
    awk -F, -v keys="$keys" -v skip="$skip" '
        function of(    i, key) {
            key = $1
            for (i = 2; i <= keys; i++)
                key = key "," $i
            return key
        }
        FNR == 1 {
            file++
            for (i = 1; i <= NF; i++)
                name[file, i] = $i
            if (file == 2)
                for (i = 1; i <= NF; i++)
                    held[i] = i > keys && name[2, i] !~ /x86|^front$/ &&
                              !(skip != "" && name[2, i] ~ skip)
            next
        }
        file == 1 {
            for (i = keys + 1; i <= NF; i++)
                value[of(), name[1, i]] = $i
            there[of()]
        }
        file == 2 {
            if (!(of() in there)) {
                print "the shipped table has no row of " of()
                bad = 1
            }
            for (i = 1; i <= NF; i++)
                if (held[i] && $i != "") {
                    compared++
                    if ($i != value[of(), name[2, i]]) {
                        printf "%s of %s is %s, shipped %s\n", name[2, i], of(), $i,
                               value[of(), name[2, i]]
                        bad = 1
                    }
                }
        }
        END {
            if (!compared)
                print "nothing was compared"
            exit bad || !compared
        }' $shipped/"$1.csv" "$scratch/small/$1.csv"
}
altered()       # CHART: the same with one changed figure
{
    cp "$scratch/small/$1.csv" "$scratch/kept"
    awk -F, -v OFS=, 'NR == 2 { for (i = 2; i < NF; i++) if ($i ~ /^[0-9.]+$/) $i += 1 }
        { print }' "$scratch/kept" >"$scratch/small/$1.csv"
    same "$1"
    code=$?
    cp "$scratch/kept" "$scratch/small/$1.csv"
    return $code
}
check "a small sweep is made" "$program" charts "$scratch/small" --small
if [ -n "$TP_SOAK" ]; then
    check "the charts of the plan are made" "$program" charts "$scratch/small" \
        --only boards,ladder,plan,predicted,regret,ticks
fi
first=
for chart in $charts; do
    [ -e "$scratch/small/$chart.csv" ] || continue
    first=${first:-$chart}
    check "$chart: what was counted and judged is as shipped" same "$chart"
done
[ -n "$first" ] && refuse "another figure would be found" altered "$first"

# -- with GNU parallel, on two machines -------------------------------------------------

program=$(realpath "$program")
cat >"$scratch/ssh" <<'END'
#!/bin/sh
# Stand-in for ssh without other machines: [OPTION]... HOST [--] COMMAND...
while [ "${1#-}" != "$1" ]; do shift; done
echo "$1" >>"$0.hosts"
shift
[ "$1" != -- ] || shift
cd / && SHELL=/bin/sh exec sh -c "$*"      # SHELL as set by a login
END
chmod +x "$scratch/ssh"
on_two()        # [OPTION]... [COMMAND]...
{
    rm -f "$scratch/ssh.hosts"
    parallel --ssh "$scratch/ssh" -S 1/one,1/two --wd "$PWD" "$@" &&
        [ "$(sort -u "$scratch/ssh.hosts" | wc -l)" = 2 ]
}
jobs()          # jobs of one chart
{
    "$program" charts --list --only sine >"$scratch/list" &&
        on_two <"$scratch/list" >"$scratch/rows" &&
        "$program" charts --collect "$scratch/rows" "$scratch/apart" --only sine &&
        cmp "$scratch/apart/sine.csv" "$scratch/small/sine.csv"
}
film()          # a film of three ranges
{
    on_two --results "$scratch/{#}.y4m" "$program" render storm --size 64x48 \
        --frames {} --out - ::: 0:9 10:19 20:29 >/dev/null &&
        "$program" render storm --size 64x48 --frames 30 --out "$scratch/one.y4m" &&
        "$program" join "$scratch/film.y4m" "$scratch"/[123].y4m &&
        cmp "$scratch/film.y4m" "$scratch/one.y4m"
}
if parallel --version 2>/dev/null </dev/null | grep -q GNU; then
    check "jobs on two machines make the same table" jobs
    check "ranges of frames on two machines make the same film" film
else
    skip "jobs and frames on two machines" "parallel"
fi
finish
