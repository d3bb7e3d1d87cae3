# SPDX-License-Identifier: MIT
# Cost against error: instructions on a Cortex-M4, with x86-64 beside; the line is the
# Pareto front by the Cortex-M4.  Each family of methods has a colour and a shape; numbers are
# table entries, degrees or steps.
@panels
@log_x
@decades_y
families = "nearest lines knots polynomial parabola cordic parabolas tp_sin-between"
titles   = "nearest lines Taylor polynomial parabola CORDIC parabolas 'lines between'"
kinds    = "1 5 3 4 6 8 3 5"
to_left  = " nearest;256 nearest;1024 nearest;4096 parabola;2 lines;256 lines;1024 " . \
           "knots;64 knots;256 polynomial;9 "
point(n)    = strcol("method") . ";" . strcol("size")
of(i, name) = strcol("method") eq word(families, i) ? column(name) : NaN
side(left)  = (strstrt(to_left, " " . point(0) . " ") > 0) == left
at(i, left) = side(left) ? of(i, "error_max") : NaN
text(i)     = word(titles, i) . " " . strcol("size")
kind(i)     = int(word(kinds, i))
cheap(count) = count < 50 ? count : NaN
dear(count)  = count < 50 ? NaN : count
set yrange [1e-9:1]

@first
set xlabel "Cortex-M4 instructions a sine"
set ylabel "largest error, of the amplitude" offset 0.5,0
set xrange [1.4:700]
plot csv using (front("m4")):(column("error_max")) @front_line title "Pareto front", \
     for [i=1:8] "" using (of(i, "m4")):"error_max" \
         with points linetype kind(i) pointsize 1.5 notitle, \
     "" using (used("m4")):"error_max" @filled title "used by every scene", \
     for [i=1:4] "" using (column("m4")):(at(i, 1)):(text(i)) \
         with labels right offset -0.9,0 textcolor linetype kind(i) notitle, \
     "" using (column("m4")):(point(0) eq "parabola;2" ? column("error_max") : NaN): \
         (text(5)) with labels right offset -0.9,0 textcolor linetype kind(5) notitle, \
     "" using (column("m4")):(point(0) eq "parabola;4" ? column("error_max") : NaN): \
         (text(5)) with labels center offset -0.5,-1.5 textcolor linetype kind(5) notitle, \
     "" using (column("m4")):(of(6, "error_max")):(text(6)) \
         with labels center offset -0.5,-0.9 textcolor linetype kind(6) notitle, \
     for [j=1:3] "" using (column("m4")):(at(2**j, 0)):(text(2**j)) \
         with labels left offset 0.9,0 textcolor linetype kind(2**j) notitle, \
     "" using (column("m4")):(at(7, 0)):(text(7)) \
         with labels left offset 0.9,-0.7 textcolor linetype kind(7) notitle, \
     "" using (cheap(used("m4"))):"error_max":(strcol("method")) with labels left \
         offset 1.0,0.25 noenhanced textcolor rgb vermillion notitle, \
     "" using (dear(used("m4"))):"error_max":(strcol("method")) with labels right \
         offset 8.0,-0.9 noenhanced textcolor rgb vermillion notitle

@second
set xlabel "x86-64 instructions"
set xrange [8:700]
plot for [i=1:8] csv using (of(i, "x86")):"error_max" \
         with points linetype kind(i) pointsize 1.5 notitle, \
     "" using (used("x86")):"error_max" @filled notitle
unset multiplot
