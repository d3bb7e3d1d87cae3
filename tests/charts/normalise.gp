# SPDX-License-Identifier: MIT
# Cost and error of a unit normal.
@panels
@log_x
@decades_y
set yrange [2e-10:5]
# Positions of the names: beside the point, with these exceptions.
above = " slopes steep-near packed-32 "
below = " packed series-1 tp_normalise unit-14 "
left  = " steep "
in(l) = strstrt(l, " " . strcol("method") . " ") > 0
place(l, name)  = in(l) ? column(name) : NaN
beside(name)    = in(above) || in(below) || in(left) ? NaN : column(name)
tone(n) = is_used(strcol("used")) ? 0xD55E00 : 0x303030

@first
set xlabel "Cortex-M4 instructions a normal"
set ylabel "largest distance from the true unit normal" offset 0.5,0
set xrange [12:400]
plot csv using (front("m4")):(column("error_max")) @front_line title "Pareto front", \
     "" using (unused("m4")):"error_max" @hollow title "method", \
     "" using (used("m4")):"error_max" @filled title "used by a scene", \
     "" using (beside("m4")):"error_max":"method":(tone(0)) with labels left \
         offset 0.9,0.1 noenhanced textcolor rgb variable notitle, \
     "" using (place(above, "m4")):"error_max":"method":(tone(0)) with labels center \
         offset 0,0.9 noenhanced textcolor rgb variable notitle, \
     "" using (place(below, "m4")):"error_max":"method":(tone(0)) with labels center \
         offset 0,-0.9 noenhanced textcolor rgb variable notitle, \
     "" using (place(left, "m4")):"error_max":"method":(tone(0)) with labels right \
         offset -1,0 noenhanced textcolor rgb variable notitle

@second
set xlabel "x86-64 instructions"
set xrange [12:400]
plot csv using (unused("x86")):"error_max" @hollow notitle, \
     "" using (used("x86")):"error_max" @filled notitle
unset multiplot
