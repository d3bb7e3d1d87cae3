# SPDX-License-Identifier: MIT
# Two panels: costs and errors, measured (across) against predicted (up); the diagonal, 10 %
# each way, and of errors the side on which a plan keeps its budget.
of(kind, name, by) = strcol("kind") eq kind ? column(name) / by : NaN
unset key
set multiplot
set tmargin at screen 0.95
set bmargin at screen 0.14
set lmargin at screen 0.09
set rmargin at screen 0.485
set logscale xy
set xtics (1, 3, 10, 30, 100)
set ytics (1, 3, 10, 30, 100)
set xlabel "counted, M instructions"
set ylabel "predicted" offset 1.5,0
set xrange [1:120]
set yrange [1:120]
set label 1 "costs; dashed: 10 % each way" at graph 0.04,0.96
plot x * 1.1 with lines linecolor rgb grey dashtype 2, x / 1.1 with lines linecolor rgb grey \
     dashtype 2, x with lines linecolor rgb grey, \
     csv using (of("cost", "m4", 1e6)):(of("cost", "predicted", 1e6)) \
         with points linecolor rgb blue pointtype 6 pointsize 1.1
set lmargin at screen 0.58
set rmargin at screen 0.975
set xlabel "measured, levels rms"
unset ylabel
set xtics (0.03, 0.1, 0.3, 1, 3, 10, 30)
set ytics (0.03, 0.1, 0.3, 1, 3, 10, 30)
set xrange [0.02:60]
set yrange [0.02:60]
set label 1 "errors" at graph 0.04,0.96
set label 2 "measured above predicted" at graph 0.97,0.06 right textcolor rgb grey
plot x with lines linecolor rgb grey, \
     csv using (of("error", "rms", 1)):(of("error", "predicted", 1)) \
         with points linecolor rgb vermillion pointtype 6 pointsize 0.9
unset multiplot
