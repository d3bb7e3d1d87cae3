# SPDX-License-Identifier: MIT
# Gerstner waves: cost per vertex against the error of the normal (above) and of the place
# (below). Each line has points for 1, 2, 3, 4 and 8 waves, as its numbers show. The grey
# steps are the Pareto front for each number of waves. Exact and sharpened waves of
# steepness 0.3 coincide with those of 0.7.
of(name, form, sum) = strcol("form") eq form && column("steepness") == sum ? \
    column(name) : NaN
series(name, i) = of(name, word("cheap cheap exact sharp", i), i == 2 ? 0.3 : 0.7)
best(name, n) = column("front") == 1 && column("waves") == n && kind(strcol("form")) < 4 \
    && column("steepness") > 0.5 ? column(name) : NaN
kind(form) = form eq "sharp" ? 4 : form eq "exact" ? 3 : column("steepness") < 0.5 ? 2 : 1
# Rows without a point lie far outside the picture, since gnuplot rejects an empty set of
# points.
taken(name, i) = is_used(strcol("used")) && kind(strcol("form")) == i ? \
    column(name) : 1e-3
array name[4] = ["cheap at 0.7", "cheap at 0.3", "exact", "sharpened"]
said(i) = name[i]
last(i, y) = column("waves") == 8 ? series(y, i) : NaN
lines_ = 'with linespoints linetype i pointsize 1.1'
used_  = 'with points linetype i pointtype int(word(shapes, i)) + 1 pointsize 1.9 notitle'

upper = 'set tmargin at screen 0.96; set bmargin at screen 0.47; unset xlabel; ' . \
        'set xtics (200, 500, 1000, 2000); set format x ""; set ytics autofreq; ' . \
        '@decades_y; set yrange [2e-5:90]'
lower = 'set format x; set tmargin at screen 0.42; set bmargin at screen 0.14; ' . \
        'unset logscale y; set format y "%g"; set ytics 0.02; set yrange [0:0.06]'
normals = 'plot for [i=1:4] csv ' . \
          'using (series(cost, i)):"normal_max" @lines_ notitle, ' . \
          'for [i=1:4] "" using (taken(cost, i)):"normal_max" @used_'
counts  = ', "" using (series(cost, 1)):"normal_max":(strcol("waves")) ' . \
          'with labels offset 0,0.8 textcolor linetype 1 notitle' . \
          ', "" using (series(cost, 3)):"normal_max":(strcol("waves")) ' . \
          'with labels offset 0,-0.8 textcolor linetype 3 notitle' . \
          ', "" using (series(cost, 4)):"normal_max":(strcol("waves")) ' . \
          'with labels offset 0,0.8 textcolor linetype 4 notitle' . \
          ', for [i=1:2] "" using ' . \
          '(series(cost, i)):(last(i, "normal_max")):(said(i)) ' . \
          'with labels left offset 2.6,0 textcolor linetype i notitle' . \
          ', for [i=3:4] "" using ' . \
          '(series(cost, i)):(last(i, "normal_max")):(said(i)) ' . \
          'with labels left offset -1,(i == 3 ? -1.9 : 1.9) textcolor linetype i notitle'
fronts  = ', for [n in "2 3 4 8"] "" ' . \
          'using (best(cost, n + 0)):(column("normal_max")) ' . \
          'smooth unique with steps linecolor rgb grey linewidth 0.8 notitle'
places  = 'plot for [i=1:4] csv using (series(cost, i)):"place_max" @lines_ notitle, ' . \
          'for [i=1:4] "" using (taken(cost, i)):"place_max" @used_'

unset key
set multiplot
@log_x
@first
set xrange [240:2500]
cost = "m4"
@upper
set ylabel "normal, degrees at most" offset 0.5,0
@normals @counts @fronts
@lower
@log_x
set ylabel "place, mm" offset 0.5,0
set xlabel "Cortex-M4 instructions a vertex"
@places

@second
set xrange [150:1500]
cost = "x86"
@upper
set format y ""
@normals
@lower
set format y ""
@log_x
set xlabel "x86-64 instructions"
@places
unset multiplot
