# SPDX-License-Identifier: MIT
# Folding of crests: points are measured without the clamp, dashed lines are the theory of
# all crests at one place, solid lines are the engine's result.
set xrange [0:1.9]
set yrange [-0.75:1.05]
set xlabel "sum of steepnesses QkA that is asked for"
set ylabel "least eigenvalue of the Jacobian" offset 0.5,0
set xtics 0.2; set ytics 0.25
unset key
set lmargin 9; set rmargin 3; set tmargin 1

of(name, sea, n) = strcol("sea") eq sea && column("waves") == n ? column(name) : NaN
at(sum, name, sea, n) = column("sum") == sum ? of(name, sea, n) : NaN

set object 1 rectangle from 0,-0.75 to 1.9,0 behind fillcolor rgb "#FBE6DA" \
    fillstyle solid noborder
set label 1 "below 0 crests fold into loops" at 0.06,-0.07 textcolor rgb vermillion
set label 2 "theory: 1 - sum, where all crests meet" at 0.06,-0.68 textcolor rgb "#505050"
set arrow 1 from 0.95,-0.75 to 0.95,1.05 nohead dashtype 3 linecolor rgb grey
set label 3 "the clamp: 0.95" at 0.97,0.98 textcolor rgb "#505050"
set label 4 "solid: the engine, 0.05 at least" at 0.06,0.06 textcolor rgb blue

array type[3] = [1, 3, 4]
array sea[3] = ["one-way", "one-way", "fan"]
array many[3] = [1, 8, 4]
array said[3] = ["1 or 2 waves", "8 waves", "4 waves over 120°"]
array where[3] = [1.4, 1.4, 1.25]
solid = 'with lines linetype type[i] linewidth 3.2'
dashed = 'with lines linecolor rgb grey dashtype 2'

# Names of scenes stand on the side with more room.
is_low = 'column("engine") < 1 - 0.8 * column("sum")'
low(y)  = (@is_low) ? y : NaN
high(y) = (@is_low) ? NaN : y
slanted = 'rotate by 50 font font . ",13" noenhanced textcolor rgb vermillion'

said_right = 'with labels right offset -0.8,-0.6 textcolor linetype type[i]'
said_left = 'with labels left offset 0.8,0.6 textcolor linetype type[i]'

plot for [i=1:3] csv using "sum":(of("engine", sea[i], many[i])) @solid, \
     for [i=1:3] "" using "sum":(of("crests", sea[i], i == 2 ? 1 : many[i])) @dashed, \
     for [i=1:3] "" using "sum":(of("unheld", sea[i], many[i])) with points \
         linetype type[i] pointsize 1.1, \
     "" using "sum":(of("unheld", "one-way", 2)) with points linetype 1 pointtype 1, \
     for [i=1:1] "" using "sum":(at(where[i], "unheld", sea[i], many[i])):(said[i]) \
         @said_right, \
     for [i=2:3] "" using "sum":(at(where[i], "unheld", sea[i], many[i])):(said[i]) \
         @said_left, \
     "" using "sum":(used("engine")) @filled, \
     "" using "sum":(high(used("engine"))):(who(strcol("used"))) with labels \
         left @slanted offset 0.6,0.6, \
     "" using "sum":(low(used("engine"))):(who(strcol("used"))) with labels \
         right @slanted offset -0.6,-0.6
