# SPDX-License-Identifier: MIT
# Lag of waves in a pool against the updates of cells that a square wave length and period
# cost, for three values of r; lines: the rule without rounding.
array r_[3] = ["0.125", "0.250", "0.484"]
shown(i, angle, name) = strcol("r") eq r_[i] && strcol("angle") eq angle ? column(name) : NaN
said(i) = strcol("side") eq "32" && strcol("r") eq r_[i] && strcol("angle") eq "axis" \
          ? column("lag") : NaN

@decades_x
@log_y
set xrange [80:500000]
set yrange [0.03:15]
set xlabel "updates of cells for a square wave length and a period"
set ylabel "lag, % of the speed"
set key at screen 0.97,0.97 right top Right noreverse vertical maxrows 6
plot for [i=1:3] csv using (shown(i, "axis", "updates")):(column("theory")) \
         with lines linetype i linewidth 1.2 notitle, \
     for [i=1:3] "" using (shown(i, "diagonal", "updates")):(column("theory")) \
         with lines linetype i linewidth 1.2 dashtype 2 notitle, \
     for [i=1:3] "" using (shown(i, "axis", "updates")):"lag" with points linetype i \
         pointtype 7 title sprintf("r = %s, along an axis", r_[i]), \
     for [i=1:3] "" using (shown(i, "diagonal", "updates")):"lag" with points linetype i \
         pointtype 6 title sprintf("r = %s, along the diagonal", r_[i]), \
     "" using (shown(1, "axis", "updates")):(said(1)):("8 cells in a wave length") \
         with labels left offset 0.8,0.6 textcolor linetype 1 notitle
