# SPDX-License-Identifier: MIT
# Filters and rates: cost of the water stages against the error of the picture, with 8 x 8
# samples a pixel as reference.  Names ending in -1 have no smaller mip levels.  Dashed: the
# error of these samples on level water, against rays.
scenes = "three-swells from-above"
of(name, i) = strcol("scene") eq word(scenes, i) ? column(name) : NaN
# A point outside of the picture replaces a missing value: gnuplot warns about empty sets.
taken(name, i) = is_used(strcol("used")) && strcol("scene") eq word(scenes, i) ? \
    column(name) : 1e-3
rays(i) = strcol("filter") eq "linear" ? of("floor_rms", i) : NaN
best(name, i) = column("front") == 1 ? of(name, i) : NaN
points_ = 'with points linetype i pointtype int(word("6 8", i))'
used_   = 'with points linetype i pointtype int(word("7 9", i)) pointsize 2 notitle'

@panels
@log_x
@log_y
set yrange [0.55:4.2]
unset key
set tmargin 2.4

# Names of points: scene, filter, rate, name; the first 8 right of their points, the others
# left of them; offset.
array named[14] = [ \
    "1 linear full linear 1 0.1",       "1 linear-1 full linear-1 1 0.1", \
    "1 nearest full nearest 0.6 -0.9",  "1 quick full quick 0.3 0.9", \
    "1 quick layers layers 0.8 -0.45",   "2 linear full linear 1 0.1", \
    "2 quick layers layers 1.6 0.4",    "1 nearest-1 full nearest-1 1 0", \
    "1 quick colour colour -1 -0.3", \
    "2 linear-1 full linear-1 -1 -0.6", "2 nearest full nearest -1 -0.7", \
    "2 nearest-1 full nearest-1 -1 -0.6", "2 quick full quick -1 0.3", \
    "2 quick colour colour -1 0.1" ]
part(k, n) = word(named[k], n)
scene_of(k) = int(part(k, 1))
is_named(k) = strcol("scene") eq word(scenes, scene_of(k)) && \
              strcol("filter") eq part(k, 2) && strcol("rate") eq part(k, 3)
at(k, name) = is_named(k) ? column(name) : NaN
by_ = 'offset real(part(k, 5)),real(part(k, 6)) textcolor linetype scene_of(k) notitle'

@first
set label 1 "○ three-swells" at screen 0.125,0.965 textcolor linetype 1
set label 2 "△ from-above" at screen 0.32,0.965 textcolor linetype 2
set label 3 "filled: of a scene" at screen 0.505,0.965
set label 4 "— Pareto front" at screen 0.74,0.965 textcolor rgb grey
set xrange [30:1000]
set xlabel "Cortex-M4 instructions of stages, a water pixel"
set ylabel "off 8 x 8 samples, rms of 255" offset 0.5,0
plot for [i=1:2] csv using (best("m4", i)):(column("colour_rms")) @front_line notitle, \
     for [i=1:2] "" using (of("m4", i)):"colour_rms" @points_, \
     for [i=1:2] "" using (taken("m4", i)):"colour_rms" @used_, \
     for [k=1:8] "" using (at(k, "m4")):"colour_rms":(part(k, 4)) with labels left @by_, \
     for [k=9:14] "" using (at(k, "m4")):"colour_rms":(part(k, 4)) with labels right @by_, \
     for [i=1:2] "" using (30):(rays(i)):(970):(0) with vectors nohead linetype i \
         dashtype 2 notitle, \
     "" using (33):(rays(2)):("the samples themselves, off rays") \
         with labels left offset 0,0.7 textcolor rgb grey notitle
unset label

@second
set ytics (0.5, 1, 2)
set xrange [90:1000]
set xlabel "x86-64 instructions"
plot for [i=1:2] csv using (of("x86", i)):"colour_rms" @points_, \
     for [i=1:2] "" using (taken("x86", i)):"colour_rms" @used_
unset multiplot
