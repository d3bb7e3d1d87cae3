# SPDX-License-Identifier: MIT
# Error of the mean reflectance of rough water against the view's elevation: waves above,
# ripples below, steeper slopes to the right.
array method[4] = ["flat", "root", "fit", "bend"]
array title_of[4] = ["flat water", "root of N.V^2 + s^2", "Bruneton's fit", \
    "the engine's bend"]
array colour[4] = [8, 3, 2, 1]
slopes = "0.05 0.1 0.2"
here(y) = strcol("kind") eq kind && column("slope") == slope ? column(y) : NaN
left(n)  = 0.105 + 0.3 * (n - 1)
curves = 'plot for [i=1:4] csv using "elevation":(here(method[i])) with linespoints ' . \
         'linetype colour[i] pointtype i == 4 ? 7 : int(word(shapes, colour[i])) ' . \
         'pointsize 0.9 notitle'
upper = 'kind = "waves"; set tmargin at screen 0.90; set bmargin at screen 0.54; ' . \
        'set yrange [-5:25]; set format x ""; unset xlabel'
lower = 'kind = "ripples"; set tmargin at screen 0.50; set bmargin at screen 0.14; ' . \
        'set yrange [-22:15]; set format x "%g"'

set multiplot
set xrange [0:45]
set xtics 10
set xzeroaxis linetype 1 linecolor rgb grey linewidth 1
unset key
array at[4] = [0.105, 0.275, 0.51, 0.715]
do for [i=1:4] {
    set label 10 + i title_of[i] at screen at[i] + 0.015,0.955 left \
        textcolor linetype colour[i] point linetype colour[i] \
        pointtype (i == 4 ? 7 : int(word(shapes, colour[i]))) pointsize 1.2 offset 0.9,0
}
do for [n = 1:3] {
    slope = word(slopes, n) + 0
    set lmargin at screen left(n)
    set rmargin at screen left(n) + 0.28
    if (n > 1) { unset ylabel; set format y "" }
    @upper
    set label 1 sprintf("waves, s = %g", slope) at graph 0.96,0.92 right
    if (n == 1) { set ylabel "error of the share, % of the light" offset 0.5,-6 }
    @curves
    unset for [i=11:14] label i
    unset ylabel
    @lower
    set label 1 sprintf("ripples, s = %g", slope) at graph 0.96,0.92 right
    if (n == 2) { set xlabel "elevation of the view, degrees" }
    @curves
}
unset multiplot
