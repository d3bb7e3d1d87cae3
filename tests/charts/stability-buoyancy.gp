# SPDX-License-Identifier: MIT
# The surface above a place: error along (left) and up (right). Dashed lines are the
# theory of plain steps, q^n of the first distance.
@decades_y
set yrange [2e-6:30]
set xrange [0:1.3]
set xtics 0.2
unset key
of(name, method) = strcol("method") eq method ? column(name) : NaN
at_end(name, method, q) = column("q") == q ? of(name, method) : NaN
steps = "1 2 4 8 16"
plain(i) = "plain-" . word(steps, i)
lines_ = 'with lines linetype i linewidth 2.2'
engine_ = 'with linespoints linecolor rgb black pointtype 2 pointsize 1'

set tmargin at screen 0.97
@panels
@first
set xlabel "q, the sum of steepnesses"
set ylabel "off, m (of waves 1.2 and 0.7 m high)" offset 0.5,0
set arrow 1 from 0.95,graph 0 to 0.95,graph 1 nohead dashtype 3 linecolor rgb grey
set label 1 "the clamp" at 0.97,4e-6 left textcolor rgb grey
set label 3 "scenes with a boat" at 0.5,9e-6 center textcolor rgb vermillion
set label 2 "along" at graph 0.04,0.95
plot for [i=1:5] csv using "q":(of("along", plain(i))) @lines_, \
     for [i=1:5] "" using "q":(of("bound", plain(i))) with lines linetype i linewidth 1 \
         dashtype 2, \
     for [i=2:5] "" using "q":(at_end("along", plain(i), 0.65)):(word(steps, i)) \
         with labels left offset 0.5,-0.7 textcolor linetype i, \
     "" using "q":(at_end("bound", plain(1), 0.3)):("1 plain step") with labels \
         offset 0,1 textcolor linetype 1, \
     "" using "q":(of("along", "engine")) @engine_, \
     "" using "q":(at_end("along", "engine", 0.95)):("the engine") with labels \
         left offset 1,0, \
     "" using "q":(used("along")) @filled
@second
set xlabel "q"
unset label 1; unset label 3
set label 2 "up"
set xrange [0:1.05]
plot for [i=1:5] csv using "q":(of("up", plain(i))) @lines_, \
     "" using "q":(of("up", "engine")) @engine_, \
     "" using "q":(used("up")) @filled
unset multiplot
