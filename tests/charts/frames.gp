# SPDX-License-Identifier: MIT
# Whole frames: one line a scene, its Pareto front from the cheapest rung to the rung
# nearest to the reference renderer. Filled: the plan's choice; hollow: the exact rung.
scenes = system("awk -F, 'NR > 1 && !seen[$1]++ { print $1 }' '" . csv . "'")
best(y, s) = strcol("scene") eq s && column("front") == 1 ? column(y) : NaN
exact(y) = strcol("rung") eq "exact" ? column(y) : NaN
taken(y) = is_used(strcol("used")) ? column(y) : NaN

# Names stand right of their points, with these exceptions.
left  = " calm-bay storm from-above "
above = " minimal count-100 harbour shallows "
below = " lava count-64 shore-break tank "
placed(list) = strstrt(list, " " . strcol("scene") . " ") > 0 ? strcol("scene") : ""
aside(s) = strstrt(left . above . below, " " . s . " ") > 0 ? "" : s
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
set xrange [85:4000]
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
set xtics (100, 300, 1000, 3000)
cost = "x86"
plot csv @marks
unset multiplot
