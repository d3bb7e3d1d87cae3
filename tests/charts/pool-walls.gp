# SPDX-License-Identifier: MIT
# Standing waves between walls: error against instructions, with numbers of cells in a wave
# length; and what a reflection does to phase and amplitude.  Lines: the grid's own lag;
# dotted: a wall that is half a cell off its place.
array bits_[6] = ["16", "16", "8", "32", "16", "16"]
array wall_[6] = ["edge", "mask", "edge", "edge", "45-degrees", "27-degrees"]
array name_[6] = ["edge, 16 bits", "mask, straight", "edge, 8 bits", "edge, 32 bits", \
                  "mask at 45°", "mask at 27°"]
of(i, y) = strcol("bits") eq bits_[i] && strcol("wall") eq wall_[i] ? column(y) : NaN
mark(i) = i < 3 ? int(word("7 5", i)) : int(word("6 4 8 10 12 14", i))
one(i, y, wave) = column("wave") == wave ? of(i, y) : NaN

set multiplot
@decades_x
@log_y
set lmargin at screen 0.105
set rmargin at screen 0.575
set tmargin at screen 0.86
set xrange [2e4:1e8]
set yrange [0.5:200]
set key at screen 0.09,0.985 maxrows 2 width -2 samplen 1
set xlabel "M4 instructions, a square wave and a period"
set ylabel "error in the fourth period, rms %" offset 1,0
plot for [i=1:6] csv using (of(i, "m4")):"error" with points linetype i pointtype mark(i) \
         pointsize 1.4 title name_[i], \
     "" using (of(1, "m4")):"theory" with lines linetype 1 linewidth 1.2 notitle, \
     "" using (of(4, "m4")):"theory" with lines linetype 4 linewidth 1.2 notitle, \
     for [w in "8 16 32 64"] "" using (one(1, "m4", int(w))):"error":(w) \
         with labels right offset -0.6,-0.6 textcolor linetype 1 notitle

unset key
unset logscale y
set format x "%g"
@log_x
set xrange [7:75]
set xtics (8, 16, 32, 64)
set lmargin at screen 0.69
set rmargin at screen 0.975
set tmargin at screen 0.86
set bmargin at screen 0.53
set yrange [-10:50]
set ytics 20
unset xlabel
set format x ""
set ylabel "phase, degrees" offset 1,0
set label 1 "of one reflection" at screen 0.69,0.895
set label 2 "half a cell" at 13,36 left textcolor rgb grey
plot 360 / x with lines dashtype 3 linecolor rgb grey notitle, \
     -360 / x with lines dashtype 3 linecolor rgb grey notitle, \
     for [i in "1 5 6"] csv using "wave":(of(int(i), "phase")) with linespoints \
         linetype int(i) pointtype mark(int(i)) pointsize 1.4

unset label
set tmargin at screen 0.47
set bmargin at screen 0.135
set yrange [80:101]
set ytics 5
set format x "%g"
set xlabel "cells in a wave length"
set ylabel "amplitude kept, %" offset 1,0
plot for [i in "1 5 6"] csv using "wave":(of(int(i), "kept")) with linespoints \
         linetype int(i) pointtype mark(int(i)) pointsize 1.4
unset multiplot
