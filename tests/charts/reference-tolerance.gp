# SPDX-License-Identifier: MIT
# The reference's picture by the accuracy of a ray's root: error (above) and, if times
# were measured, time (below). From the pictures of 80x60.
scenes = "three-swells storm shore-break tank"
size   = "80x60"
of(name, i) = strcol("scene") eq word(scenes, i) && strcol("size") eq size \
              ? column(name) : NaN
taken(i)    = is_used(strcol("used")) ? of("rms", i) : NaN
timed = int(system(sprintf("test -s '%s' && echo 1 || echo 0", time_csv)))

set logscale x
set format x "10^{%L}"
set xrange [3e-11:3e-2]
unset key
set multiplot
set lmargin at screen 0.125; set rmargin at screen 0.975
set tmargin at screen 0.9
set bmargin at screen (timed ? 0.42 : 0.14)
set key at screen 0.11,0.985 width 1
set logscale y
set format y "10^{%L}"
set yrange [5e-7:1]
set ylabel "rms against 10^{-12} m, of 255" offset 0.5,0
if (timed) { set format x "" } else { set xlabel "tolerance of a ray's root, m" }
plot for [i=1:4] csv using "tolerance":(of("rms", i)) with linespoints linetype i \
         title word(scenes, i), \
     for [i=1:4] "" using "tolerance":(taken(i)) \
         with points linetype i pointtype int(word(shapes, i)) + 1 pointsize 2 notitle
if (timed) {
    unset key
    set tmargin at screen 0.37; set bmargin at screen 0.14
    set format x "10^{%L}"
    set xlabel "tolerance of a ray's root, m"
    set format y "%g"
    set yrange [2:1000]
    set ytics (1, 10, 100, 1000)
    set ylabel "ms" offset 0.5,0
    plot for [i=1:4] time_csv using "tolerance":(of("ms", i)) with linespoints \
        linetype i notitle
}
unset multiplot
