# SPDX-License-Identifier: MIT
# Water renderers, a gentle scene above and a steep scene below: cost of finding the water
# against the error of the colours.  Each line has 500, 2000, 8000 and 32000 vertices and
# the scene's own number; projected and flat have no grid, and are points.  Filled: the choice
# of the scene; dotted: the Pareto front.
array name[4] = ["triangles", "rows", "projected", "flat"]
method(n) = n eq "triangles" ? 1 : n eq "rows" ? 2 : n eq "projected" ? 3 : 4
here(y) = strcol("scene") eq scene ? column(y) : NaN
of(y, i) = strcol("method") eq name[i] ? here(y) : NaN
one(y, i) = column("grid") == 2000 ? of(y, i) : NaN
taken(y) = is_used(strcol("used")) ? here(y) : NaN
full(n) = int(word(shapes, method(n))) + 1
lines_ = 'with linespoints linetype i pointsize 1.2'
used_  = 'with points pointtype variable linecolor variable pointsize 2.4 notitle'

upper = 'set tmargin at screen 0.965; set bmargin at screen 0.56; unset xlabel; ' . \
        'scene = "calm-bay"; ' . \
        'set xtics ("" 50, "" 100, "" 200, "" 500, "" 1000)'
lower = 'set tmargin at screen 0.53; set bmargin at screen 0.125; scene = "count-64"; ' . \
        '@log_x'
beside = 'set ytics ("" 2, "" 5, "" 10, "" 20, "" 50)'
lines = 'plot for [i=1:2] csv using (of(cost, i)):"colour" @lines_ notitle, ' . \
        'for [i=3:4] "" using (one(cost, i)):"colour" @lines_ notitle, ' . \
        '"" using (taken(cost)):"colour":(full(strcol("method"))):(method(strcol("method"))) @used_'
front = ', "" using (column("front") == 1 ? here(cost) : NaN):"colour" ' . \
        'smooth unique with steps linecolor rgb grey dashtype 3 linewidth 2 notitle'
far_apart(n) = n eq "500" || n eq "8000" || n eq "32000" ? n : ""
said = ', "" using (of(cost, 1)):"colour":(far_apart(strcol("grid"))) ' . \
       'with labels right offset -0.8,-0.7 textcolor linetype 1 notitle' . \
       ', "" using (of(cost, 2)):"colour":(far_apart(strcol("grid"))) ' . \
       'with labels left offset 0.8,0.6 textcolor linetype 2 notitle'

unset key
set multiplot
@log_x
@log_y
set xrange [45:1100]
set yrange [1.2:50]
@first
cost = "m4_seen"
@upper
set label 1 "calm-bay, gentle" at graph 0.98, 0.92 right
set label 2 "flat" at 61, 30 center textcolor linetype 4
set label 3 "projected" at 430, 7.6 center textcolor linetype 3
set label 4 "triangles" at 130, 5 right textcolor linetype 1
set label 5 "rows" at 170, 7.2 left textcolor linetype 2
set ylabel "colours, rms levels" offset 0.5,0
@lines @front @said
@lower
set label 1 "count-64, steep"
set label 2 at 61, 19
set label 3 at 480, 20 center
unset label 4
unset label 5
set xlabel "Cortex-M4 instructions a water pixel"
@lines @front @said

@second
unset label
cost = "x86_seen"
@upper
@beside
@lines
@lower
@beside
set xtics ("" 50, 100, "" 200, 300, "" 500, 1000)
set xlabel "x86-64 instructions"
@lines
unset multiplot
