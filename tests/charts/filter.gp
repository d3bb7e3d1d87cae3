# SPDX-License-Identifier: MIT
# Filters and rates: the cost of the water's stages against the picture's difference from
# 8 x 8 samples a pixel. Names ending in -1 have only the textures' first mipmap level;
# the dashed lines are the difference of the samples of level water from rays.
scenes = "three-swells from-above"
of(name, i) = strcol("scene") eq word(scenes, i) ? column(name) : NaN
quick(name, i, rate) = strcol("filter") eq "quick" && strcol("rate") eq rate ? \
    of(name, i) : NaN
exact(name, i, filter) = strcol("filter") eq filter ? of(name, i) : NaN
# Rows without a point lie far outside the picture, since gnuplot rejects an empty set of
# points.
taken(name, i) = is_used(strcol("used")) && strcol("scene") eq word(scenes, i) ? \
    column(name) : 1e-3
rays(i) = strcol("filter") eq "linear" ? of("floor_rms", i) : NaN
best(name, i) = column("front") == 1 ? of(name, i) : NaN
points_ = 'with points linetype i pointtype int(word("6 8", i))'
used_   = 'with points linetype i pointtype int(word("7 9", i)) pointsize 2 notitle'

@panels
@log_x
@log_y
set yrange [0.42:4.2]

@first
set key at screen 0.11,0.985 maxrows 1 width -3
set xrange [30:1000]
set xlabel "Cortex-M4 instructions of stages, a water pixel"
set ylabel "off 8 x 8 samples, rms of 255" offset 0.5,0
plot for [i=1:2] csv using (best("m4", i)):(column("colour_rms")) @front_line \
         title i == 1 ? "Pareto front" : "", \
     for [i=1:2] "" using (of("m4", i)):"colour_rms" @points_ title word(scenes, i), \
     for [i=1:2] "" using (taken("m4", i)):"colour_rms" @used_, \
     for [i=1:2] for [f in "linear linear-1"] "" \
         using (exact("m4", i, f)):"colour_rms":(f) \
         with labels left offset 1,0.1 textcolor linetype i notitle, \
     for [i=1:2] for [f in "nearest nearest-1"] "" \
         using (exact("m4", i, f)):"colour_rms":(f) \
         with labels right offset -1,(f eq "nearest" ? -0.6 : 0.2) \
         textcolor linetype i notitle, \
     for [i=1:2] "" using (quick("m4", i, "full")):"colour_rms":("quick") \
         with labels left offset (i == 1 ? 1 : -0.5),(i == 1 ? 0.3 : -1.7) \
         textcolor linetype i notitle, \
     for [i=1:2] "" using (quick("m4", i, "layers")):"colour_rms":("layers") \
         with labels right offset 0,(i == 1 ? 0.8 : -0.9) textcolor linetype i notitle, \
     for [i=1:2] "" using (quick("m4", i, "colour")):"colour_rms":("colour") \
         with labels right offset -1,0.1 textcolor linetype i notitle, \
     for [i=1:2] "" using (30):(rays(i)):(970):(0) with vectors nohead linetype i \
         dashtype 2 notitle, \
     "" using (33):(rays(1)):("the samples themselves, off rays") \
         with labels left offset 0,0.7 textcolor rgb grey notitle

@second
set ytics (0.5, 1, 2)
set xrange [90:1000]
set xlabel "x86-64 instructions"
plot for [i=1:2] csv using (of("x86", i)):"colour_rms" @points_, \
     for [i=1:2] "" using (taken("x86", i)):"colour_rms" @used_
unset multiplot
