# SPDX-License-Identifier: MIT
# Methods for a normal: instructions against the rms error.
@panels
@log_x
@decades_y
set yrange [1e-4:10]

@first
set xlabel "Cortex-M4 instructions a normal"
set ylabel "off the exact normal, degrees rms" offset 0.5,0
set xrange [20:2500]
plot csv using (front("m4")):(column("normal_rms")) @front_line title "Pareto front", \
     "" using (unused("m4")):"normal_rms" @hollow title "method", \
     "" using (used("m4")):"normal_rms" @filled title "used by a scene", \
     "" using (unused("m4")):"normal_rms":(strcol("method")) @names notitle, \
     "" using (used("m4")):"normal_rms":(by("method")) @names_used notitle

@second
set xlabel "x86-64 instructions"
set xrange [20:1000]
plot csv using (unused("x86")):"normal_rms" @hollow notitle, \
     "" using (used("x86")):"normal_rms" @filled notitle
unset multiplot
