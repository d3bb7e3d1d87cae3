# SPDX-License-Identifier: MIT
# A line for each feature of a pixel of water: its cost by three methods of shading.
# Costs below half an instruction stand in a column of their own, 0, left of the axis of logarithms.
of(rung) = strcol("what") eq "shaded" && strcol("rung") eq rung
none     = 0.45
price    = '(column("figure") < 0.5 ? none : column("figure"))'
set yrange [*:*] reverse
set offsets 0, 0, 0.7, 0.7
@log_x
set xtics ("0" none, "1" 1, "2" 2, "5" 5, "10" 10, "20" 20, "50" 50, "100" 100, \
           "200" 200, "500" 500, "1k" 1000)
set xrange [0.36:1000]
set arrow 1 from 0.66,graph 0 to 0.66,graph 1 nohead linecolor rgb grey linewidth 1.2
set xlabel "Cortex-M4 instructions a pixel of water"
set lmargin 13
unset key
set label 1 "○ exact" at screen 0.19,0.965 textcolor linetype 1
set label 2 "● quick" at screen 0.33,0.965 textcolor rgb vermillion
set label 3 "△ quick, colour at half the rate" at screen 0.47,0.965 textcolor rgb green
set ytics () font font . ",13"
k = 0
stats csv using (of("exact.full") ? (k = k + 1, k) : NaN) nooutput
array item[k]
k = 0
stats csv using (of("exact.full") ? (k = k + 1, item[k] = strcol("item"), k) : NaN) nooutput
set for [i=1:|item|] ytics add (item[i] i)
plot k = 0, csv using (of("exact.full") ? (k = k + 1, @price) : NaN):(k) \
         with points linetype 1 pointsize 2.1, \
     k = 0, csv using (of("quick.full") ? (k = k + 1, @price) : NaN):(k) \
         with points linecolor rgb vermillion pointtype 7 pointsize 1.1, \
     k = 0, csv using (of("quick.colour") ? (k = k + 1, @price) : NaN):(k) \
         with points linecolor rgb green pointtype 8 pointsize 1.7
