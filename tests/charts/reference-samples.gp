# SPDX-License-Identifier: MIT
# Error of the reference's picture by samples a pixel: one line a scene, with its slope
# beside its name; from the small pictures if the sweep has no others.
scenes = "three-swells storm tank count-64"
larger = int(system(sprintf("grep -c 160x120 '%s' || true", csv)))
size   = larger > 0 ? "160x120" : "40x30"
at(i)    = strcol("scene") eq word(scenes, i) && strcol("size") eq size \
           ? column("rms") : NaN
taken(i) = is_used(strcol("used")) ? at(i) : NaN
last(i)  = column("samples") == 64 ? at(i) : NaN
said(i)  = sprintf("%s, slope %.2f", word(scenes, i), column("slope"))

set logscale x
set xtics (1, 4, 16, 64)
set xrange [0.8:700]
@log_y
set yrange [0.2:30]
set xlabel "samples a pixel"
set ylabel "rms against 256 samples, of 255"
unset key
set tmargin at screen 0.96
set label 1 "as if at random: slope -1/2" at 5.5,17 textcolor rgb grey
half(x) = x < 1 || x > 64 ? NaN : 24 / sqrt(x)
plot half(x) with lines linecolor rgb grey dashtype 2 linewidth 1.2 notitle, \
     for [i=1:4] csv using "samples":(at(i)) with linespoints linetype i notitle, \
     for [i=1:4] "" using "samples":(taken(i)) \
         with points linetype i pointtype int(word(shapes, i)) + 1 pointsize 2 notitle, \
     for [i=1:4] "" using "samples":(last(i)):(said(i)) \
         with labels left offset 1,(i == 1 ? 0.6 : i == 2 ? -0.6 : 0) noenhanced \
         textcolor linetype i notitle
