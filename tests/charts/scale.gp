# SPDX-License-Identifier: MIT
# Cost of a frame, or of a tick for cells, by the number of each, in millions of
# instructions, with the nearest line and its equation; the busiest of n threads, with a
# frame shared evenly.
array kinds[4] = ["pixels", "vertices", "waves", "cells"]
array words_[4] = ["pixels", "vertices of the grid", "waves", "cells of a pool, a tick"]
array processor[2] = ["m4", "x86"]
array base[8]
array slope[8]
mine(name) = strcol("of") eq kind ? column(name) : NaN
do for [i=0:7] {
    kind = kinds[i / 2 + 1]
    stats csv using (mine(processor[i % 2 + 1] . "_base")) name "b" nooutput
    stats csv using (mine(processor[i % 2 + 1] . "_slope")) name "s" nooutput
    base[i + 1] = b_mean
    slope[i + 1] = s_mean
}

millions(name) = mine(name) * 1e-6
fit(i, x) = (base[i] + slope[i] * x) * 1e-6
big(v) = v < 1e3 ? sprintf("%.3g", v) : v < 1e6 ? sprintf("%.3g k", v * 1e-3) : \
         sprintf("%.3g M", v * 1e-6)
equation(i) = big(base[i]) . " + " . big(slope[i]) . " n"
of_threads(n) = strcol("of") eq "threads" ? column("x86") : NaN
stats csv using (of_threads(0)) name "t" nooutput

array left[3] = [0.115, 0.425, 0.735]
place = 'k = panel - 1; set lmargin at screen left[k % 3 + 1]; ' . \
        'set rmargin at screen left[k % 3 + 1] + 0.245; ' . \
        'set tmargin at screen (k < 3 ? 0.985 : 0.485); ' . \
        'set bmargin at screen (k < 3 ? 0.645 : 0.145)'
both  = 'kind = kinds[panel]; m = 2 * panel - 1; ' . \
        'set xlabel words_[panel] offset 0,0.5; ' . \
        'set label 1 equation(m) at graph 0.04,0.93 left textcolor linetype 1; ' . \
        'set label 2 equation(m + 1) at graph 0.04,0.81 left textcolor linetype 2; ' . \
        'plot fit(m, x) with lines linetype 1 linewidth 1.2 notitle, ' . \
        'fit(m + 1, x) with lines linetype 2 linewidth 1.2 notitle, ' . \
        'csv using "n":(millions("m4")) with points linetype 1 pointtype 7 notitle, ' . \
        '"" using "n":(millions("x86")) with points linetype 2 pointtype 5 notitle'

unset key
set multiplot
@log_x
@log_y
panel = 1
@place
set xtics (5000, 20000, 80000, 300000)
set format x "%.0s%c"
set xrange [4000:400000]
set yrange [1.5:900]
set ytics (2, 5, 20, 50, 200, 500)
set ylabel "M instructions" offset 1.2,0
@both
panel = 2
@place
unset ylabel
@log_y
set xtics (500, 2000, 8000, 32000)
set xrange [450:45000]
set yrange [8:200]
@both
panel = 3
@place
set xtics (1, 2, 4, 8, 16)
set xrange [0.8:20]
set yrange [8:60]
@both
panel = 4
@place
set xtics (300, 3000, 30000)
set xrange [200:90000]
set yrange [0.005:40]
set ytics (0.01, 0.1, 1, 10)
set ylabel "M instructions" offset 1.2,0
@both

panel = 5
@place
unset label
unset ylabel
set xlabel "threads" offset 0,0.5
set xtics (1, 2, 4, 8)
set ytics (20, 50, 100, 200)
set xrange [0.85:9.5]
set yrange [10:400]
set label 1 "busiest thread" at graph 0.04,0.1 left
plot t_max * 1e-6 / x with lines dashtype 2 linecolor rgb grey notitle, \
     csv using "n":(of_threads(0) * 1e-6) with points linetype 2 pointtype 5 notitle

panel = 6
@place
unset label
unset logscale
unset border
unset tics
unset xlabel
set label 1 "{/*1.2 ●} Cortex-M4" at graph 0.05,0.8 left textcolor linetype 1
set label 2 "{/*1.2 ■} x86-64" at graph 0.05,0.62 left textcolor linetype 2
set label 3 "count-64's frame;" at graph 0.05,0.42 left
set label 4 "tank's cells; threads" at graph 0.05,0.29 left
set label 5 "draw three-swells," at graph 0.05,0.16 left
set label 6 "on two cores" at graph 0.05,0.03 left
set xrange [0:1]
set yrange [0:1]
plot -1 notitle
unset multiplot
