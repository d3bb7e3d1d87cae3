# SPDX-License-Identifier: MIT
# Above: instructions per cell against the error after 200 ticks, for all pools; the line
# is the front of 64 x 64 cells at r = 0.484, damping 1/64. Below, over the damping, for r
# = 0.484: error, error of the grid alone (dashed), and ticks until rest.
bits(n) = int(column("bits")) == 4 * 2**n
usual(any) = column("size") == 64 && column("r") == 0.484
along(n, name) = bits(n) && usual(0) ? column(name) : NaN
front_of(name) = column("front") == 1 && usual(0) && column("m") == 6 ? column(name) : NaN
shape(bits) = bits == 8 ? 6 : bits == 16 ? 8 : 4
rgb_of(bits) = bits == 8 ? 0xD55E00 : bits == 16 ? 0x0072B2 : 0x009E73
colour(n) = word("#D55E00 #0072B2 #009E73", n)

# Hollow: used by no scene; filled: used by a scene. Columns: x, y, shape, colour.
hollow_ones = 'with points pointtype variable linecolor rgb variable pointsize 0.9 linewidth 1'
filled_ones = 'with points pointtype variable linecolor rgb variable pointsize 1.5'

set multiplot
set key off
set tics font font . ",13"
left_half  = 'set lmargin at screen 0.12; set rmargin at screen 0.505'
right_half = 'set lmargin at screen 0.615; set rmargin at screen 0.985'
upper = 'set tmargin at screen 0.92; set bmargin at screen 0.61'
lower = 'set tmargin at screen 0.45; set bmargin at screen 0.14'
damping = 'set xrange [3.5:12.4]; set xlabel "share of motion that a tick takes"; ' . \
    'set xtics ("1/16" 4, "1/64" 6, "1/256" 8, "1/1024" 10)'

set label 1 "○ 8 bits" at screen 0.03,0.965 textcolor rgb colour(1)
set label 2 "△ 16 bits" at screen 0.15,0.965 textcolor rgb colour(2)
set label 3 "□ 32 bits" at screen 0.285,0.965 textcolor rgb colour(3)
set label 4 "filled: of a scene" at screen 0.43,0.965
set label 5 "— front" at screen 0.64,0.965 textcolor rgb grey
set label 6 "- - the grid alone" at screen 0.76,0.965

@decades_y
set format y "%g"
@upper
@left_half
set xlabel "Cortex-M4 instructions a cell" offset 0,0.3
set ylabel "error at tick 200, %" offset 0.6,0
set yrange [3:2000]
set xrange [30:120]
plot csv using (front_of("m4")):"error_200" with lines linecolor rgb grey linewidth 2.4, \
     "" using (unused("m4")):"error_200":(shape(column("bits"))):(rgb_of(column("bits"))) \
         @hollow_ones, \
     "" using (used("m4")):"error_200":(shape(column("bits")) + 1):(rgb_of(column("bits"))) \
         @filled_ones
unset for [i=1:6] label i

@right_half
set xlabel "x86-64 instructions a cell"
unset ylabel
set xrange [*:*]
set offsets graph 0.04, graph 0.04, 0, 0
plot csv using (unused("x86")):"error_200":(shape(column("bits"))):(rgb_of(column("bits"))) \
         @hollow_ones, \
     "" using (used("x86")):"error_200":(shape(column("bits")) + 1):(rgb_of(column("bits"))) \
         @filled_ones

set offsets
@lower
@left_half
@damping
set ylabel "error at tick 200, %" offset 0.6,0
set yrange [10:800]
set ytics (10, 30, 100, 300)
plot for [n=1:3] csv using "m":(along(n, "error_200")) with linespoints \
         pointtype shape(4 * 2**n) linecolor rgb colour(n) pointsize 1.2, \
     for [n=1:3] "" using "m":(along(n, "grid_200")) with lines dashtype 2 \
         linecolor rgb colour(n) linewidth 1.4, \
     "" using "m":(used("error_200")):(shape(column("bits")) + 1):(rgb_of(column("bits"))) \
         @filled_ones

@right_half
set ylabel "ticks until rest" offset 0.6,0
set yrange [50:50000]
set ytics (100, 1000, 10000)
plot for [n=1:3] csv using "m":(along(n, "rest")) with linespoints \
         pointtype shape(4 * 2**n) linecolor rgb colour(n) pointsize 1.2, \
     "" using "m":(used("rest")):(shape(column("bits")) + 1):(rgb_of(column("bits"))) \
         @filled_ones, \
     "" using "m":(used("rest")):(strcol("used")) with labels right offset -0.5,0.6 \
         noenhanced font font . ",13" textcolor rgb "#303030"
unset multiplot
