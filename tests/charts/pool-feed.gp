# SPDX-License-Identifier: MIT
# Level of a driven field: tick by tick for splashes of several heights; share of ticks with
# a splash, lines by the balance of energy; error of the level against cost.  Filled: pond.
array splash[5] = ["0.25", "1", "4", "5.83", "16"]
array m_[3] = ["4", "6", "8"]
trace(i) = strcol("splash") eq splash[i] && strcol("most") eq "1.33" && column("tick") > 0 ? \
           column("level") : NaN
whole(i, y) = strcol("m") eq m_[i] && strcol("most") eq "1.33" && column("tick") == 0 ? \
              column(y) : NaN
tight(i, y) = strcol("m") eq m_[i] && strcol("most") eq "1.02" ? column(y) : NaN
filled_(y) = is_used(strcol("used")) ? column(y) : NaN

set multiplot
set lmargin at screen 0.1
set rmargin at screen 0.49
set tmargin at screen 0.875
set bmargin at screen 0.58
set xrange [0:800]
set yrange [0:135]
set xtics 200
set ytics 50
set label 1 "splash" at screen 0.03,0.965
set key at screen 0.1,0.985 maxrows 1 width -1 samplen 0.5
set xlabel "tick, damping 1/64" offset 0,0.6
set ylabel "level, % of drive_{min}" offset 1,0
plot 100 with lines linecolor rgb grey dashtype 2 linewidth 1 notitle, \
     for [i=1:5] csv using "tick":(trace(i)) with lines linetype i linewidth 1.4 \
         title splash[i]

set tmargin at screen 0.41
set bmargin at screen 0.135
@log_x
@log_y
set xrange [0.2:20]
set yrange [0.8:150]
set xtics (0.25, 1, 4, 16)
set ytics (1, 10, 100)
unset key
set xlabel "drive_{amplitude} / drive_{min}" offset 0,0.3
set ylabel "ticks with a splash, %"
plot for [i=1:3] csv using (column("splash")):(whole(i, "theory")) with lines \
         linetype i dashtype 2 linewidth 1.2, \
     for [i=1:3] csv using (column("splash")):(whole(i, "share")) with points linetype i

set lmargin at screen 0.6
set rmargin at screen 0.975
set tmargin at screen 0.875
unset logscale
set logscale y
set xrange [53:80]
set yrange [2:15]
set xtics 5
set ytics (2, 3, 5, 10)
unset label
set label 2 "damping" at screen 0.6,0.965
set label 3 "x: drive_{max} is 1.02" at screen 0.6,0.915
set key at screen 0.69,0.985 maxrows 1 width -2 samplen 0.3
set xlabel "Cortex-M4 instructions a cell and tick" offset 0,0.3
set ylabel "error of the level, rms %"
plot for [i=1:3] csv using (whole(i, "m4")):"error" with points linetype i \
         title sprintf("1/%d", 2**int(m_[i])), \
     for [i=1:3] "" using (tight(i, "m4")):"error" with points linetype i pointtype 2 \
         notitle, \
     "" using (filled_("m4")):"error" with points linetype 2 pointtype 5 pointsize 2 notitle, \
     "" using (filled_("m4")):"error":("pond") with labels right offset -1,-0.5 \
         textcolor linetype 2 notitle, \
     for [i=1:3] "" using (whole(i, "m4")):"error":(column("splash") == 16 || \
         column("splash") == 8 ? strcol("splash") : "") with labels left offset 0.8,0.5 \
         textcolor linetype i notitle
unset multiplot
