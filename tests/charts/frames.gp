# SPDX-License-Identifier: MIT
# Whole frames: a line for each scene, its Pareto front from the cheapest rung to the most
# accurate rung.  Filled: the choice of the plan; hollow: the exact rung.
scenes = system("awk -F, 'NR > 1 && !seen[$1]++ { print $1 }' '" . csv . "'")
best(y, s) = strcol("scene") eq s && column("front") == 1 ? column(y) : NaN
exact(y) = strcol("rung") eq "exact" ? column(y) : NaN
taken(y) = is_used(strcol("used")) ? column(y) : NaN

# Names stand right of their points, with these exceptions; where points are close, a thin
# line leads from the point to the name.
left  = " from-above "
above = " raindrops minimal count-100 "
below = " lava count-64 "
array far[9]    = ["storm", "flat-calm", "tank", "pond", "harbour", "three-swells", \
                   "calm-bay", "deep-sea", "night-sea"]
array far_x[9]  = [700, 900, 1480, 1850, 2280, 2000, 1640, 1120, 760]
array far_y[9]  = [16.5, 36.5, 42, 39, 31.6, 28.6, 25.8, 19, 20.2]
left_of = " storm flat-calm night-sea "
is_far(s) = sum [i=1:|far|] (far[i] eq s ? 1 : 0)
placed(list) = strstrt(list, " " . strcol("scene") . " ") > 0 ? strcol("scene") : ""
aside(s) = is_far(s) || strstrt(left . above . below, " " . s . " ") > 0 ? "" : s
on_left(i) = strstrt(left_of, " " . far[i] . " ") > 0
far_at(i, y) = strcol("scene") eq far[i] ? taken(y) : NaN
names_ = 'notitle with labels noenhanced textcolor rgb "#202020"'
marks = 'using (exact(cost)):"psnr" with points linecolor rgb black pointtype 6 ' . \
        'pointsize 1.3 notitle, ' . \
        '"" using (taken(cost)):"psnr" with points linecolor rgb vermillion pointtype 7 ' . \
        'pointsize 1.9 notitle'

unset key
set multiplot
@log_x
set yrange [14:52]
set tmargin at screen 0.98
set bmargin at screen 0.135
set lmargin at screen 0.085
set rmargin at screen 0.73
set xrange [70:5000]
set ylabel "PSNR to the reference, dB" offset 0.8,0
set xlabel "Cortex-M4 instructions a pixel"
set label 1 "●" at graph 0.62,0.95 textcolor rgb vermillion
set label 2 "the plan's rung" at graph 0.655,0.95
set label 3 "○" at graph 0.62,0.89 textcolor rgb black
set label 4 "the exact rung" at graph 0.655,0.89
set label 5 "—" at graph 0.617,0.83 textcolor rgb sky
set label 6 "Pareto front" at graph 0.655,0.83
cost = "m4"
plot for [s in scenes] csv using (best(cost, s)):"psnr" smooth unique with linespoints \
         linecolor rgb sky linewidth 2 pointtype 7 pointsize 0.6 notitle, "" @marks, \
     for [i=1:|far|] "" using (far_at(i, cost)):(far_at(i, "psnr")): \
         (far_x[i] - far_at(i, cost)):(far_y[i] - far_at(i, "psnr")) \
         with vectors nohead linecolor rgb grey linewidth 0.8 notitle, \
     for [i=1:|far|] "" using (on_left(i) ? far_at(i, cost) * 0 + far_x[i] : NaN): \
         (far_y[i]):(far[i]) @names_ right offset -0.3,0, \
     for [i=1:|far|] "" using (on_left(i) ? NaN : far_at(i, cost) * 0 + far_x[i]): \
         (far_y[i]):(far[i]) @names_ left offset 0.3,0, \
     "" using (taken(cost)):"psnr":(aside(strcol("scene"))) @names_ left offset 1,0, \
     "" using (taken(cost)):"psnr":(placed(left)) @names_ right offset -1,0, \
     "" using (taken(cost)):"psnr":(placed(above)) @names_ center offset 0,1, \
     "" using (taken(cost)):"psnr":(placed(below)) @names_ center offset 0,-1
unset label
set lmargin at screen 0.765
set rmargin at screen 0.985
unset ylabel
set format y ""
set xlabel "x86-64 instructions"
set xtics ("100" 100, "300" 300, "1k" 1000, "3k" 3000)
cost = "x86"
plot csv @marks
unset multiplot
