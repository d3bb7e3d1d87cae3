# SPDX-License-Identifier: MIT
# Perspective in large triangles: cost of their spans for a water pixel against the error of
# the picture.  The line of each scene is its Pareto front; numbers are the pixels between
# two exact texture positions.
scenes = "plane three-swells from-above"
of(name, i) = strcol("scene") eq word(scenes, i) ? column(name) : NaN
# A point outside of the picture replaces a missing value: gnuplot warns about empty sets.
taken(name, i) = is_used(strcol("used")) && strcol("scene") eq word(scenes, i) ? \
    column(name) : 1e-3
best(name, i) = column("front") == 1 ? of(name, i) : NaN
points_ = 'with points linetype i'
used_  = 'with points linetype i pointtype int(word(shapes, i)) + 1 pointsize 2 notitle'

one(name, i) = strcol("step") eq "1" ? of(name, i) : NaN
# Steps of 8, 16 and 32 are close together: one label at the middle names all three.
steps(name, i) = strcol("step") eq "16" ? of(name, i) : NaN
affine(name, i) = strcol("step") eq "affine" ? of(name, i) : NaN
array said[3] = ["large level squares, affine", "three-swells, affine", \
                 "from-above: all alike"]

unset key
set tmargin 1.2
@panels
@log_x
@log_y
set yrange [0.03:12]

@first
set xrange [28:420]
set xlabel "Cortex-M4 instructions of rows, a water pixel"
set ylabel "off places in double, rms of 255" offset 0.5,0
plot for [i=1:3] csv using (best("m4", i)):(column("colour_rms")) @front_line, \
     for [i=1:3] "" using (of("m4", i)):"colour_rms" @points_, \
     for [i=1:3] "" using (taken("m4", i)):"colour_rms" @used_, \
     for [i=1:2] "" using (one("m4", i)):"colour_rms":(strcol("step")) \
         with labels left offset 0.9,0 textcolor linetype i, \
     for [i=1:2] "" using (steps("m4", i)):"colour_rms":("32, 16, 8") \
         with labels center offset 0,-1.2 textcolor linetype i, \
     for [i=1:3] "" using (affine("m4", i)):"colour_rms":(said[i]) \
         with labels left offset int(word("0 -2 -5", i)),0.9 textcolor linetype i

@second
set ytics (0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10)
set xrange [28:400]
set xtics (50, 100, 200)
set xlabel "x86-64 instructions"
plot for [i=1:3] csv using (of("x86", i)):"colour_rms" @points_, \
     for [i=1:3] "" using (taken("x86", i)):"colour_rms" @used_
unset multiplot
