# SPDX-License-Identifier: MIT
# Cost and error of the Fresnel reflectance; the numbers are a table's steps. The exact
# law lies far below the picture.
@panels
@log_x
@decades_y
least = 2e-5
set yrange [least:0.4]
is(name)     = strcol("method") eq name
of(name, of) = is(name) ? column(of) : NaN
formula(of)  = strcol("steps") eq "0" && column("error_max") > least ? column(of) : NaN
steps(n)     = strcol("steps")

@first
set xlabel "Cortex-M4 instructions a sample"
set ylabel "largest error of the share" offset 0.5,0
set xrange [1.9:500]
plot csv using (front("m4")):(column("error_max")) @front_line title "Pareto front", \
     "" using (of("nearest", "m4")):"error_max" with points linetype 1 notitle, \
     "" using (of("lines", "m4")):"error_max" with points linetype 3 notitle, \
     "" using (of("table-nearest", "m4")):"error_max" with points linetype 4 notitle, \
     "" using (of("schlick-table", "m4")):"error_max" with points linetype 5 \
         title "Schlick, 256 steps", \
     "" using (formula("m4")):"error_max" \
         with points linetype 8 notitle, \
     "" using (used("m4")):"error_max" @filled title "used by a scene", \
     "" using (of("nearest", "m4")):"error_max":("middles " . steps(0)) \
         with labels right offset -0.9,0 textcolor linetype 1 notitle, \
     "" using (of("lines", "m4")):"error_max":("lines " . steps(0)) \
         with labels left offset 0.9,0 textcolor linetype 3 notitle, \
     "" using (of("table-nearest", "m4")):"error_max":("rounded 256") \
         with labels left offset 0.9,-0.2 textcolor linetype 4 notitle, \
     "" using (of("schlick", "m4")):"error_max":("Schlick") \
         with labels left offset 0.9,0 textcolor linetype 8 notitle, \
     "" using (of("schlick-16-bit", "m4")):"error_max":("in 16 bits") \
         with labels center offset 0,0.9 textcolor linetype 8 notitle, \
     "" using (is("law") ? column("m4") : NaN):(1.6 * least): \
         (sprintf("law: %.0e", column("error_max"))) with labels center \
         textcolor linetype 8 notitle, \
     "" using (used("m4")):"error_max":(by("method")) with labels left offset 0.9,0.1 \
         noenhanced textcolor rgb vermillion notitle

@second
set xlabel "x86-64 instructions"
set xrange [8:400]
plot csv using (of("nearest", "x86")):"error_max" with points linetype 1 notitle, \
     "" using (of("lines", "x86")):"error_max" with points linetype 3 notitle, \
     "" using (of("table-nearest", "x86")):"error_max" with points linetype 4 notitle, \
     "" using (of("schlick-table", "x86")):"error_max" with points linetype 5 notitle, \
     "" using (formula("x86")):"error_max" \
         with points linetype 8 notitle, \
     "" using (used("x86")):"error_max" @filled notitle
unset multiplot
