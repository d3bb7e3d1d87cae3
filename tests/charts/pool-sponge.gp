# SPDX-License-Identifier: MIT
# What a sponge sends back, by the wave length, square on: points are measured, lines are the
# rule without rounding; and by cost, for three waves.  Filled: a scene's width.
array width_[6] = ["4", "8", "16", "24", "32", "64"]
square(i, y) = strcol("angle") eq "0" && strcol("width") eq width_[i] ? column(y) : NaN
used_(i, y) = is_used(strcol("used")) ? square(i, y) : NaN
edge(y, angle) = strcol("angle") eq angle && strcol("width") eq "0" ? column(y) : NaN
at(y, angle, wave) = strcol("angle") eq angle && strcol("wave") eq wave ? column(y) : NaN
taken(y, angle, wave) = is_used(strcol("used")) ? at(y, angle, wave) : NaN
radiate(y, angle, wave) = strcol("width") eq "0" ? at(y, angle, wave) : NaN
wide(w) = strcol("width") eq w && strcol("angle") eq "0" && strcol("wave") eq "8"
array angles[4] = ["0", "0", "0", "45"]
array waves[4] = ["8", "16", "32", "16"]
array said[4] = ["8", "16", "32", "16, 45°"]

set multiplot
@log_x
@log_y
set lmargin at screen 0.1
set rmargin at screen 0.535
set tmargin at screen 0.86
set yrange [0.7:100]
set xrange [5.5:44]
set xtics (6, 8, 12, 16, 24, 32, 40)
set label 1 "sponge of" at screen 0.1,0.965
set label 2 "dashed: radiating edge; dotted: 16, smooth" at screen 0.1,0.89 textcolor rgb grey
set key at screen 0.2,0.985 maxrows 1 width 0 samplen 0.3
set xlabel "cells in a wave length"
set ylabel "amplitude that comes back, %" offset 1,0
plot for [i=1:6] csv using (strcol("angle") eq "0" ? column("wave") : NaN):(square(i, "back")) \
         with points linetype i pointtype 6 title width_[i], \
     for [i=1:6] "" using "wave":(square(i, "theory")) with lines linetype i \
         linewidth 1.2 notitle, \
     for [i=3:4] "" using "wave":(used_(i, "back")) with points linetype i pointtype 7 notitle, \
     "" using "wave":(edge("theory", "0")) with lines linecolor rgb grey dashtype 2 \
         notitle, \
     "" using "wave":(square(3, "smooth")) with lines linetype 3 linewidth 1.2 dashtype 3 \
         notitle

set lmargin at screen 0.6
set rmargin at screen 0.975
unset ylabel
set format y ""
set xrange [0.55:6.5]
set xtics (1, 2, 5)
unset label
set label 3 "waves of" at screen 0.6,0.965
set key at screen 0.7,0.985 maxrows 1 width -1 samplen 0.3
set xlabel "Cortex-M4 instructions a tick, M"
plot for [i=1:4] csv using (column("m4") / 1e6):(at("back", angles[i], waves[i])) \
         with linespoints linetype i pointtype 6 pointsize 1.4 title said[i], \
     for [i=1:4] "" using (column("m4") / 1e6):(taken("back", angles[i], waves[i])) \
         with points linetype i pointtype 7 pointsize 1.6 notitle, \
     for [i=1:4] "" using (column("m4") / 1e6):(radiate("theory", angles[i], waves[i])) \
         with points linetype i pointtype 2 pointsize 1.4 notitle, \
     for [w in "4 8 16 32 64"] "" using (wide(w) ? column("m4") / 1e6 : NaN):(88):(w) \
         with labels offset (w eq "4" ? -0.5 : 0),0.4 \
         textcolor rgb "#303030" notitle, \
     "" using (column("m4") / 1e6):(radiate("theory", "45", "16")):("radiating") \
         with labels left offset 0.8,0.5 textcolor rgb grey notitle
unset multiplot
