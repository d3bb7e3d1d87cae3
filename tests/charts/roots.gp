# SPDX-License-Identifier: MIT
# Reciprocals, roots and reciprocal roots, a panel each: instructions on a Cortex-M4
# above, on x86-64 below; lines are the Pareto fronts. Each start has a colour and a
# shape: its points descend with each step of Newton (or Heron).
set multiplot
@log_x
@decades_y
set xrange [7:1000]
set yrange [2e-11:0.3]
set mxtics 10
set ytics 1e-10,100
unset key
tasks   = "recip root rsqrt"
names   = "'1 / x' '√x' '1 / √x'"
starts  = "table-4 table-6 table-8 line- lines- divide bitwise"
titles  = "'4 bits' '6 bits' '8 bits' 'line' 'lines' 'division' 'by digits' 'other'"
colours = "0x0072B2 0x56B4E9 0x009E73 0xCC79A7 0xE69F00 0x000000 0x000000 0x707070"
shapes  = "6 14 8 10 12 2 1 3"
shape(s)  = int(word(shapes, s))
colour(s) = int(word(colours, s))
has(s)    = strstrt(strcol("method"), word(starts, s)) > 0
start(n)  = has(1) ? 1 : has(2) ? 2 : has(3) ? 3 : has(4) ? 4 : has(5) ? 5 : \
            has(6) ? 6 : has(7) ? 7 : 8
of(t, name)    = strcol("what") eq word(tasks, t) ? column(name) : NaN
above(n)       = strcol("method") eq "tp_fx_recip"
left(t)        = 0.115 + 0.3 * (t - 1)
array at[9] = [0.03, 0.135, 0.24, 0.345, 0.43, 0.53, 0.665, 0.81, 0.905]

# Legend above the panels.
do for [s=1:8] {
    set label s word(titles, s) at screen at[s], screen 0.97 left offset 1.2,0 \
        point pointtype shape(s) pointsize 1.3 linewidth 2 linecolor rgb colour(s)
}
set label 9 "used" at screen at[9], screen 0.97 left offset 1.2,0 \
    point pointtype 7 pointsize 2 linecolor rgb vermillion
set label 10 "largest relative error" at screen 0.022, screen 0.52 center rotate by 90

do for [row=1:2] {
    cost = word("m4 x86", row)
    set tmargin at screen (row == 1 ? 0.89 : 0.45)
    set bmargin at screen (row == 1 ? 0.50 : 0.135)
    if (row == 1) { set xtics ("" 10, "" 100, "" 1000) }
    if (row == 2) { set xtics ("10" 10, "100" 100, "1k" 1000) }
    do for [t=1:3] {
        set lmargin at screen left(t)
        set rmargin at screen left(t) + 0.27
        if (t == 1) { set format y "10^{%L}" } else { set format y "" }
        if (row == 1) { set title word(names, t) offset 0,-0.6 } else { unset title }
        set xlabel (t == 2 && row == 2 ? "instructions" : "") offset 0,0.4
        set label 11 (row == 1 ? "Cortex-M4" : "x86-64") at graph 0.97,0.9 right \
            textcolor rgb grey
        plot csv using (row == 2 ? 1e9 : column("front") == 1 ? of(t, cost) : NaN): \
                 (column("error_max")) @front_line, \
             "" using (is_used(strcol("used")) ? NaN : of(t, cost)):"error_max": \
                 (shape(start(0))):(colour(start(0))) with points pointtype variable \
                 linecolor rgb variable linewidth 2 pointsize 1.3, \
             "" using (is_used(strcol("used")) ? of(t, cost) : NaN):"error_max" @filled, \
             "" using (row == 1 && !above(0) && is_used(strcol("used")) ? of(t, cost) \
                 : 1e9):"error_max":"method" with labels center offset 0,-0.9 noenhanced \
                 textcolor rgb vermillion, \
             "" using (row == 1 && above(0) && is_used(strcol("used")) ? of(t, cost) \
                 : 1e9):"error_max":"method" with labels center offset 0,0.9 noenhanced \
                 textcolor rgb vermillion
        do for [s=1:10] { unset label s }
    }
}
unset multiplot
