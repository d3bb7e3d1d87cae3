# SPDX-License-Identifier: MIT
# Whole frames: a line a scene, its Pareto front from the cheapest rung to the nearest to the
# reference renderer, upwards.  Filled: what the plan chose; hollow: the exact rung.
scenes = system("awk -F, 'NR > 1 && !seen[$1]++ { print $1 }' '" . csv . "'")
here(y, s) = strcol("scene") eq s ? column(y) : NaN
best(y, s) = column("front") == 1 ? here(y, s) : NaN
exact(y) = strcol("rung") eq "exact" ? column(y) : NaN
taken(y) = is_used(strcol("used")) ? column(y) : NaN

# Names stand right of their points, or left, above or below where those are close.
left  = "calm-bay"
above = ""
below = ""
is_in(list, s) = strstrt(" " . list . " ", " " . s . " ") > 0
aside(s) = is_in(left . above . below, s) ? "" : s
placed(list) = is_in(list, strcol("scene")) ? strcol("scene") : ""
names_ = 'notitle with labels noenhanced textcolor rgb "#202020"'

lines_ = 'for [s in scenes] csv using (best(cost, s)):"psnr" smooth unique with lines ' . \
         'linecolor rgb sky linewidth 2 notitle, '
marks_ = '"" using (exact(cost)):"psnr" with points linecolor rgb black pointtype 6 pointsize 1.3 notitle, ' . \
         '"" using (taken(cost)):"psnr" with points linecolor rgb vermillion pointtype 7 pointsize 1.9 notitle'

unset key
set multiplot
@log_x
set yrange [14:52]
set lmargin at screen 0.085
set rmargin at screen 0.73
set tmargin at screen 0.98
set bmargin at screen 0.135
set xrange [85:4000]
set ylabel "dB from the reference (PSNR)" offset 0.8,0
set xlabel "Cortex-M4 instructions a pixel"
cost = "m4"
plot @lines_ @marks_, \
     "" using (taken(cost)):"psnr":(aside(strcol("scene"))) @names_ left offset 1,0, \
     "" using (taken(cost)):"psnr":(placed(left)) @names_ right offset -1,0
set lmargin at screen 0.765
set rmargin at screen 0.985
unset ylabel
set format y ""
set xlabel "x86-64 instructions"
set xtics (100, 300, 1000, 3000)
cost = "x86"
plot @lines_ @marks_
unset multiplot
