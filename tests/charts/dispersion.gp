# SPDX-License-Identifier: MIT
# Cost and error of a wave number over a depth.
@panels
@decades_x
@decades_y
set yrange [3e-9:10]
is_table(n)  = strstrt(strcol("method"), "table") == 1
is_step(n)   = strcol("method") eq "newton-1"
table(name)  = is_table(0) ? column(name) : NaN
others(name) = is_table(0) ? NaN : unused(name)

@first
set xlabel "Cortex-M4 instructions a wave number"
set ylabel "largest relative error, k h of 0.01 to 10" offset 0.5,0
set xrange [6:14000]
plot csv using (front("m4")):(column("error_max")) @front_line title "Pareto front", \
     "" using (unused("m4")):"error_max" @hollow title "method", \
     "" using (used("m4")):"error_max" @filled title "used by a scene", \
     "" using (table("m4")):"error_max":"method" with labels right offset -0.9,0 \
         textcolor rgb "#303030" notitle, \
     "" using (is_step(0) ? NaN : others("m4")):"error_max":"method" with labels left \
         offset 0.9,0.25 textcolor rgb "#303030" notitle, \
     "" using (is_step(0) ? others("m4") : NaN):"error_max":"method" with labels left \
         offset 0.9,-0.35 textcolor rgb "#303030" notitle, \
     "" using (used("m4")):"error_max":(by("method")) with labels center \
         offset -0.5,-0.9 textcolor rgb vermillion notitle

@second
set xlabel "x86-64 instructions"
plot csv using (unused("x86")):"error_max" @hollow notitle, \
     "" using (used("x86")):"error_max" @filled notitle
unset multiplot
