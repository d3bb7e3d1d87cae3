# SPDX-License-Identifier: MIT
# A line for each scene, and below those of plain water: pictures a second of each board.
# Hollow: the step's RAM exceeds the board's.  Left of the axis' least number stand boards
# with fewer, or whose ticks alone are too dear, each board in a place of its own.
eval sized(880, 13)
plain_ = "plain-64+cheap plain-64 Pico3D small3dlib tgx EmberGL TinyGL"
scenes = system("awk -F, 'NR > 1 && index(\" " . plain_ . " \", \" \" $1 \" \") == 0" . \
                " && !seen[$1]++ { print $1 }' '" . csv . "'")
boards_ = "stm32f746 esp32s3 stm32f405 rp2350 nrf52840 rp2040 microbit"
all = words(scenes) + words(plain_)
least = 0.2
row(s) = (sum [i=1:words(scenes)] (word(scenes, i) eq s ? i : 0)) \
       + sum [i=1:words(plain_)] (word(plain_, i) eq s ? words(scenes) + 1 + i : 0)
x(b) = strcol("board") ne word(boards_, b) ? NaN \
     : column("pictures") < least ? least * 0.92 * 0.86**(8 - b) : column("pictures")
full(b) = strcol("fits") eq "0" ? NaN : x(b)
hollow_(b) = strcol("fits") eq "0" ? x(b) : NaN
# Boards of a line stand a little apart.
y(b) = row(strcol("scene")) + 0.08 * (b - 4)
set lmargin 16
set tmargin 3.2
set logscale x
set xrange [least * 0.26:80]
set xtics ("less" least * 0.5); set for [m in "0.2 0.5 1 2 5 10 20 50"] xtics add (m m + 0.0)
set yrange [all + 1.8:0.3]
set ytics ()
set for [i=1:words(scenes)] ytics add (word(scenes, i) i)
set for [i=1:words(plain_)] ytics add (word(plain_, i) words(scenes) + 1 + i)
set ytics noenhanced
set xlabel "pictures a second, 320x240"
set arrow 2 from least * 0.96,graph 0 to least * 0.96,graph 1 nohead linecolor rgb grey
set arrow 1 from 10,graph 0 to 10,graph 1 nohead linecolor rgb grey dashtype 2 back
set label 1 "plain water, 64 points a side: Tidepool, and others without the waves" \
    at least * 0.28,words(scenes) + 1 left textcolor rgb grey
set key at screen 0.02,0.985 width -0.5
# The key has its own entries: gnuplot leaves out boards without a full mark.
plot for [b=1:words(boards_)] csv using (full(b)):(y(b)) with points linetype b \
         pointtype int(word("5 7 9 11 13 15 3", b)) pointsize 1.3 notitle, \
     for [b=1:words(boards_)] keyentry with points linetype b \
         pointtype int(word("5 7 9 11 13 15 3", b)) pointsize 1.3 title word(boards_, b), \
     for [b=1:words(boards_)] csv using (hollow_(b)):(y(b)) with points linetype b \
         pointtype int(word("4 6 8 10 12 14 3", b)) pointsize 1.3 notitle
