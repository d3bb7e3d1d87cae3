#!/bin/sh
# SPDX-License-Identifier: MIT
# tidepool check: rows at the limits of the models' ranges are accepted.  Rows just beyond
# are refused with file, line, column, value and range. check_ranges.awk computes the
# rows.
#     check_ranges.sh PROGRAM
formulas=$(realpath tests/host/check_ranges.awk) || exit 2
. "$(dirname "$0")/../lib/script.sh"
program_begin "$1"

# table MODEL [AWK OPTION...]: makes t/MODEL.csv from the shipped notes and column names,
# with a row for each line of the input.
table() {
    model=$1
    shift
    rm -rf t
    mkdir t
    {
        grep '^#' "$vectors/$model.csv" | grep -v -e '^# wave' -e '^# ring'
        head=$(grep -v '^#' "$vectors/$model.csv" | head -n 1)
        awk -v model="$model" -v head="$head" "$@" -f "$formulas"
    } >"t/$model.csv"
}

# holds NAME: the table holds.
holds() {
    expect "$model: $1" 0 "" check --vectors t
    cp "t/$model.csv" good.csv
}

# beyond COLUMN VALUE RANGE: the table is refused with this value in its last row.
beyond() {
    awk -F, -v OFS=, -v name="$1" -v value="$2" -v rows="$(wc -l <good.csv)" '
        !/^#/ && !names { names = 1; for (i = 1; i <= NF; i++) if ($i == name) at = i }
        NR == rows { $at = value }
        { print }' good.csv >"t/$model.csv"
    expect "$model: $1 = $2 is refused" 3 \
        "^t/$model.csv:$(wc -l <good.csv): $1 = $2 is outside $3$" check --vectors t
}

# line NAME PATTERN LINE SCRIPT: a table changed by a sed script is refused.
line() {
    sed -e "$4" good.csv >"t/$model.csv"
    expect "$model: $1" 3 "^t/$model.csv:$3: $2$" check --vectors t
}

# over NAME PATTERN: the table is read, and its numbers are found to be wrong.
over() { expect "$model: $1" 1 "^t/$model.csv:[0-9]*: $2" check --vectors t; }

# -- a limit exceeded by the rounding of a double ----------------------------------------

table sine </dev/null
echo 1073741824,1.0000000000000002,0,65536,0 >>t/sine.csv
holds "1 may be 1.0000000000000002"
beyond sin 1.00000001 "-1..1"
beyond cos -1.00000001 "-1..1"

table fresnel </dev/null
echo 1.0000000000000002,0.02,0.02,0.020363681,0.02037 >>t/fresnel.csv
holds "a cosine may be 1.0000000000000002"
beyond cos_i 1.00000001 "0..1"

table exposure </dev/null
echo 0,0.03125,8.0000000000000018,1.35 >>t/exposure.csv
holds "the ends of a clamp may be beyond it by a rounding"
beyond target 8.0000001 "0..8.00000001"

table time_scale </dev/null
awk 'BEGIN { s = 1; for (i = 0; i < 900; i++) {
    s += (4 - s) * (1 - exp(-1 / 24)); acc += s; n = int(acc); acc -= n; all += n
    last = i < 899 ? s : 4.0000000000000009
    printf "%d,4,%.17g,%.17g,%d,%d\n", i, last, acc, n, all } }' \
    >>t/time_scale.csv
holds "so may the fastest scale"
beyond scale 4.0000001 "0..4"

# -- one wave over a depth ---------------------------------------------------------------

table dispersion <<'ROWS'
0.4 0.0000152587890625
0.4 8000
35.8 0.0000152587890625
35.8 8000
0.4 0.001
35.8 0.3
3.1 0.0001
ROWS
holds "the shortest and the longest wave over the least and the greatest depth"
beyond T 0.39 "0.4..35.8"
beyond T 35.9 "0.4..35.8"
beyond h 1.52e-05 "1.52587891e-05..8000"
beyond h 8000.1 "1.52587891e-05..8000"
beyond k 1310.1 "0.003..1310"
beyond L 2002.1 "0.0048..2002"
table dispersion <<'ROWS'
8 0.0078125
ROWS
awk -F, -v OFS=, '/^8,/ { $11 *= 1.0007 } { print }' t/dispersion.csv >t/new &&
    mv t/new t/dispersion.csv
over "a depth that 16.16 holds explains no error" "cg is off by"

table shoaling_phase <<'ROWS'
35.8 8000 30 32767
35.8 8000 -89 32767
0.4 0.5 0 4
0.4 8000 60 100
5.5 3.1 40 2000.3
ROWS
holds "phases up to the end of 16.16"
beyond x 32767.5 "0..32767"
beyond kz 26.1 "-26..26"

table wind_phase <<'ROWS'
64 0.0078125 0.3
64 -0.0078125 2.3
0.005 99.99 0.7
0.001 100 1
ROWS
holds "a push of 1/2 and the least radius"
beyond r 64.1 "0.001..64"
line "a push that is held is refused" \
    "lambda r = 0.50048 is outside -0.5..0.5, where it is held" 3 '3s/0.0078125/0.00782/'

table breaking_criteria <<'ROWS'
0.4 32 8000 1
35.8 32 0.0000152587890625 1
35.8 0.001 8000 1
0.4 32 8000 0.0001
0.4 0.001 0.0000152587890625 0.0001
35.8 0.001 0.3 0.3
0.7 0.1 0.05 0.02
ROWS
holds "the lowest and the highest wave, the flattest and the steepest floor"
beyond H0 32.1 "0.001..32"
beyond H 1540.1 "0.0009..1540"
beyond H_miche 285.1 "1e-05..285"
beyond xi0 1416.1 "8e-06..1416"

# -- swells ------------------------------------------------------------------------------

table gerstner_single <<'ROWS'
0.25 0.95 40 30000 -30000 1.571 0
0.25 0.95 100 0.1 0.2 1.56 0
2000 0.0502654 200 -30000 30000 0 0
1.25 0.93 77 0 0 1.5 0
1.25 0.93 77 30000 30000 1.5 0
106 0.9 -20 123.456 654.321 1.4 0
60 0 0 1 1 1 0
ROWS
holds "from 0.25 to 2000 m, any steepness and any place"
beyond L 0.249 "0.25..2000"
beyond L 2000.1 "0.25..2000"
beyond S 0.951 "0..0.950000001"
beyond x0 30000.1 "-30000..30000"
beyond px 30303.1 "-30303..30303"
beyond t 10000001 "0..10000000"
line "an amplitude above 16 m is refused" \
    "A = S L / 2 pi = 16.2338042 m is above 16" 5 '5s/0.0502[0-9]*/0.051/'

# The bound of deep_water.h at the origin is 0.0008 degrees for S = 0.1 and 0.0027 for 0.93.  S
# is 2 pi A / L, with an A exact in Q16.16.
table gerstner_single <<'ROWS'
1.25 0.1000155473701438 77 0 0 1.5 0.002
ROWS
over "a gentle wave's normal, 0.002 degrees off, is found" "normal is off by 2"
table gerstner_single <<'ROWS'
1.25 0.92997585265566995 77 0 0 1.5 0.005
ROWS
over "a steep wave's normal, 0.005 degrees off, is found" "normal is off by [12]"

highest="0.25 0.075 0 30 1;2000 16 0 200 5"
for model in sum_of_sines gerstner_sum buoyancy; do
    case $model in
    sum_of_sines) waves=$highest ;;
    *) waves="0.25 0.0375 0.8 30 1;2000 16 3.899 200 5" ;;
    esac
    table $model -v waves="$waves" <<'ROWS'
30000 -30000 0
-30000 30000 10000000
0.1 0.2 5
0 0 1
ROWS
    holds "the shortest and the longest wave, as steep as is legal"
    first=$(grep -n '^# wave 0' good.csv | cut -d: -f1)
    line "a longer wave is refused" "L = 2000.1 is outside 0.25..2000" $((first + 1)) \
        's/L=2000 /L=2000.1 /'
    line "a higher one too" "A = 16.1 is outside 1.52587891e-05..16" $((first + 1)) \
        's/A=16 /A=16.1 /'
    line "so is one above 0.3 of its length" \
        "A = 0.0751 is above 0.3 L, where it is cut" "$first" \
        "${first}s/A=0.0[0-9]* /A=0.0751 /"
    beyond t 10000001 "0..10000000"
done
line "steepness above 0.95 is refused" \
    "sum Q k A = 0.95[0-9]* is above 0.95, where it is scaled down" $((first + 1)) \
    's/Q=3.89[0-9]* /Q=4 /'
beyond x 30000.1 "-30000..30000"
beyond x0 30303.1 "-30303..30303"

table sharp_sine <<'ROWS'
1 1.88495 1.5
8 1.88495 1.5707963
8 1.88495 0.9
8 0.0000152587890625 1.1
ROWS
holds "the least and the greatest amplitude"
beyond A 1.885 "1.52587891e-05..1.88495"
beyond A 1.52e-05 "1.52587891e-05..1.88495"

# -- rings and drops ---------------------------------------------------------------------

ring() {        # CX CZ T0 A L C TAU P0 TR
    ring=$(printf '# ring 0: cx=%s cz=%s t0=%s A=%s L=%s c=%s tau=%s p0=%s tr=%s' "$@")
    table droplet_waves -v ring="$*"
    sed "1a $ring" t/droplet_waves.csv >t/new && mv t/new t/droplet_waves.csv
}
ring 32767 -32767 9999990 4 64 64 1000 1000 8 <<'ROWS'
32417 -32767 9999995
32767 -32447 9999995.25
32000 -32767 10000000
ROWS
holds "the highest, longest and fastest ring at the end of all places and times"
beyond x 32767.5 "-32767..32767"
beyond t 10000001 "0..10000000"
line "an earlier end of its own is refused" "cx = 32767.5 is outside -32767..32767" 2 \
    's/cx=32767 /cx=32767.5 /'
ring -32767 32766 0 0.001 0.02 0.01 0.05 0.01 0 <<'ROWS'
-32767 32766 1
-32766.99 32766 0.0078125
-32766.98765 32766.004 0.01
ROWS
holds "the shortest and slowest one"
ring 0 0 0 4 0.02 0.01 1000 1000 0 <<'ROWS'
0.01220703125 0 0.01171875
0.015625 0 0.01171875
ROWS
holds "one whose slope is held has a height"

table drop_bounce <<'ROWS'
100 0.9 1 1 10000
100 0.5 1 1 100
100 0.8 0.0000152587890625 0.002 100
0.01 0.9 1 1 10000
0.01 0.8 0.0000152587890625 0.002 100
0.01 0.1 1 0.002 1000
2.5 0.65 0.2 0.00347 1234.5
ROWS
holds "the lightest and the heaviest drop, from the least and the greatest height"
beyond y0 100.1 "0.01..100"
beyond y0 0.0099 "0.01..100"
beyond eff 1.01 "1.52587891e-05..1"
beyond b 7 "0..6, or not a whole number"
beyond m 41901 "5e-08..41900"
beyond m 4.9e-08 "5e-08..41900"
beyond rad 0.000499 "0.0005..1"
beyond rad 1.001 "0.0005..1"
beyond v 44.31 "0..44.3"
beyond E_lost 42000001 "0..42000000"
beyond L 0.00399 "0.004..8.00000001"
beyond A0 7.51 "6e-13..7.5"
first=$(($(wc -l <good.csv) - 6))
line "a drop that is lighter than any is refused" \
    "m / (4/3 pi rad^3) = 9[0-9.]* is outside 100..10000" "$first" \
    "${first}s/,0.0002[0-9]*,0.003/,0.00001658,0.003/"
line "so is a smaller one" "rad = 0.0019 at the first impact is below 0.002" "$first" \
    "${first}s/,0.00347[0-9]*,/,0.0019,/"

# -- orbits and breaking crests ----------------------------------------------------------

orbits() {      # K0 KX KY
    table fr_orbit -v k="$*"
    sed "1s/K0=[^ ]* Kx=[^ ]* Ky=[^ ]*/K0=$1 Kx=$2 Ky=$3/" t/fr_orbit.csv >t/new &&
        mv t/new t/fr_orbit.csv
}
orbits 0.1 0.11 0.09 <<'ROWS'
64 8000 0 0.0031 1
64 0.0000152587890625 0.7 0.0031 2
0.001 0.0000152587890625 1.5 900 2.5
0.001 8000 -1.5708 0.003 -2
ROWS
holds "the least and the greatest radius, depth and number"
orbits 4 4 0.001 <<'ROWS'
0.001 0.0625 0.3 26 1
64 8000 1.2 0.0031 -1
ROWS
holds "the greatest rates, and the least upwards"
orbits 0 0.001 0.001 <<'ROWS'
0.1 0.125 0.3 0.0031 1
64 8000 1.2 0.0031 -1
10 3.3 1.4 0.01 2
ROWS
holds "the least rates"
beyond Sx 8192.1 "0..8192"
beyond Sy 2.001 "0..2"
beyond r 64.1 "0.001..64"
beyond h 8000.1 "1.52587891e-05..8000"
beyond h 1.52e-05 "1.52587891e-05..8000"
beyond gamma 1.571 "-1.5708..1.5708"
beyond k 1310.1 "0.003..1310"
line "an orbit that the core narrows is refused" \
    "k r = 0.951 is above 0.95, where r is held" 5 '5s/,0.01,/,0.0951,/'

table breaking <<'ROWS'
64 8000 0 0.0031 128 4 4 3
64 90 0.5 0.0031 128 0 0 -3
64 90.07 0.3 0.01 128 0.01 0.003 3.05
0.001 0.0015 0.785 900 128 0 0 2.9
0.001 0.0000152587890625 0.1 900 0 4 4 -1.5
1.5 2.3 0.2 0.3 1.4 0.3 0.2 -2.6
ROWS
holds "the least and the greatest radius, depth and stretch"
beyond St_max 128.1 "0..128"
beyond gate 1.0001 "0..1"
line "an orbit that the core narrows is refused" \
    "k r = 0.96 is above 0.95, where r is held" 8 '8s/^1.5,/3.2,/'

# -- rays --------------------------------------------------------------------------------

table reflect_refract <<'ROWS'
0 8000 0
89.9 8000 0
89.9 0 0
45 1234.56789 10
89.9 200 41
ROWS
holds "floors from the surface down to 8000 m, rays up to half a degree from level"
beyond d 8000.1 "0..8000"
beyond offx 32768.1 "-32768..32768"
beyond ry -1.00000001 "-1..1"
finish
