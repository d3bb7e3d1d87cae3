# SPDX-License-Identifier: MIT
# Perspective in large triangles: cost of the rows per water pixel against the error of
# the picture. The line of a scene is its Pareto front; the numbers are pixels between
# exact places.
scenes = "plane three-swells from-above"
of(name, i) = strcol("scene") eq word(scenes, i) ? column(name) : NaN
# Rows without a point lie far outside the picture, since gnuplot rejects an empty set of
# points.
taken(name, i) = is_used(strcol("used")) && strcol("scene") eq word(scenes, i) ? \
    column(name) : 1e-3
best(name, i) = column("front") == 1 ? of(name, i) : NaN
points_ = 'with points linetype i'
used_  = 'with points linetype i pointtype int(word(shapes, i)) + 1 pointsize 2 notitle'

step(name, i) = strcol("step") ne "affine" ? of(name, i) : NaN
affine(name, i) = strcol("step") eq "affine" ? of(name, i) : NaN
array said[3] = ["large level squares,\naffine", "three-swells,\naffine", \
                 "from-above:\nall alike"]

unset key
set tmargin 1.2
@panels
@log_x
@log_y
set yrange [0.035:28]

@first
set xrange [19:560]
set xlabel "Cortex-M4 instructions of rows, a water pixel"
set ylabel "off places in double, rms of 255" offset 0.5,0
plot for [i=1:3] csv using (best("m4", i)):(column("colour_rms")) @front_line, \
     for [i=1:3] "" using (of("m4", i)):"colour_rms" @points_, \
     for [i=1:3] "" using (taken("m4", i)):"colour_rms" @used_, \
     "" using (step("m4", 1)):"colour_rms":(strcol("step")) \
         with labels right offset -0.7,-0.5 textcolor linetype 1, \
     "" using (step("m4", 2)):"colour_rms":(strcol("step")) \
         with labels right offset -0.9,-0.2 textcolor linetype 2, \
     for [i=1:3] "" using (affine("m4", i)):"colour_rms":(said[i]) \
         with labels left offset 0.8,(i == 3 ? -1 : 1.5) textcolor linetype i

@second
set ytics (0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20)
set xrange [19:400]
set xlabel "x86-64 instructions"
plot for [i=1:3] csv using (of("x86", i)):"colour_rms" @points_, \
     for [i=1:3] "" using (taken("x86", i)):"colour_rms" @used_
unset multiplot
