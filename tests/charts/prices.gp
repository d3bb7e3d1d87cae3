# SPDX-License-Identifier: MIT
# One line for each feature of a water pixel: its cost by three methods of shading. Costs
# below one instruction are drawn at one.
of(rung) = strcol("what") eq "shaded" && strcol("rung") eq rung
price    = '(column("figure") > 1 ? column("figure") : 1)'
set yrange [*:*] reverse
set offsets 0, 0, 0.7, 0.7
@log_x
set xrange [0.9:1000]
set xlabel "Cortex-M4 instructions a pixel of water"
set lmargin 13
set tmargin 4.6
set ytics () font font . ",13"
k = 0
stats csv using (of("exact.full") ? (k = k + 1, k) : NaN) nooutput
array item[k]
k = 0
stats csv using (of("exact.full") ? (k = k + 1, item[k] = strcol("item"), k) : NaN) nooutput
set for [i=1:|item|] ytics add (item[i] i)
plot k = 0, csv using (of("exact.full") ? (k = k + 1, @price) : NaN):(k) \
         with points linetype 1 pointsize 1.6 title "exact", \
     k = 0, csv using (of("quick.full") ? (k = k + 1, @price) : NaN):(k) \
         with points linecolor rgb vermillion pointtype 7 pointsize 1.6 title "quick", \
     k = 0, csv using (of("quick.colour") ? (k = k + 1, @price) : NaN):(k) \
         with points linecolor rgb green pointtype 8 pointsize 1.6 \
         title "quick, colour at half the rate"
