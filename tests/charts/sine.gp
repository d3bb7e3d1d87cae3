# SPDX-License-Identifier: MIT
# Cost against error, the model of its kind: instructions on a Cortex-M4, and on x86-64
# beside; the line is the Pareto front by the M4's.
@panels
@log_x
@decades_y
set offsets graph 0.03, graph 0.25, graph 0.08, graph 0.03

@first
set xlabel "Cortex-M4 instructions a sine"
set ylabel "largest error (1 = the sine's amplitude)" offset 0.5,0
plot csv using (front("m4")):(column("error_max")) @front_line title "Pareto front", \
     "" using (unused("m4")):"error_max" @hollow title "method", \
     "" using (used("m4")):"error_max" @filled title "used by a scene", \
     "" using (unused("m4")):"error_max":(strcol("method")) @names notitle, \
     "" using (used("m4")):"error_max":(by("method")) @names_used notitle

@second
set xlabel "x86-64 instructions"
set offsets graph 0.06, graph 0.12, graph 0.08, graph 0.03
plot csv using (unused("x86")):"error_max" @hollow notitle, \
     "" using (used("x86")):"error_max" @filled notitle
unset multiplot
