# SPDX-License-Identifier: MIT
# Errors of whole frames by scene: rms with its range over four ticks and other cameras;
# structural similarity; twinkle of the moving scenes.
scenes = system("awk -F, 'NR > 1 && !n[$1]++ { print $1 }' '" . csv . "'")
count_ = words(scenes)
row(s) = sum [i=1:count_] (word(scenes, i) eq s ? count_ - i : 0)
of(rung, name) = strcol("rung") eq rung && strcol("of") eq name ? column("mean") : NaN

unset key
set multiplot
set yrange [-0.7:count_ - 0.3]
set tmargin at screen 0.90
set bmargin at screen 0.125
set ytics ()
set for [i=1:count_] ytics add (word(scenes, i) count_ - i)

set lmargin at screen 0.175
set rmargin at screen 0.56
set logscale x
set xtics (1, 2, 5, 10, 20, 50)
set xrange [0.7:60]
set xlabel "rms against 16 samples, of 255"
set label 1 "● the scene's own camera: mean of four ticks, bar: least to largest" \
    at screen 0.03,0.97 textcolor linetype 1
set label 2 "○ the same by exact rungs" at screen 0.03,0.925 textcolor linetype 1
set label 3 "▲ camera at 14 m" at screen 0.385,0.925 textcolor linetype 2
set label 4 "◇ camera at 50 m" at screen 0.63,0.925
plot csv using (of("shipped", "rms")):(row(strcol("scene"))):(column("least")):(column("most")) \
         with xerrorbars linetype 1 pointtype 7 pointsize 1.0 notitle, \
     "" using (of("exact", "rms")):(row(strcol("scene"))) \
         with points linetype 1 pointtype 6 pointsize 2.1 linewidth 1.2 notitle, \
     "" using (of("shipped", "14-m")):(row(strcol("scene"))) \
         with points linetype 2 pointtype 9 pointsize 1.5 notitle, \
     "" using (of("shipped", "50-m")):(row(strcol("scene"))) \
         with points linecolor rgb black pointtype 12 pointsize 1.7 notitle

unset label
unset logscale x
set ytics ()
set for [i=1:count_] ytics add ("" count_ - i)
set lmargin at screen 0.585
set rmargin at screen 0.77
set xtics 0.2
set xrange [0.35:1]
set xlabel "SSIM"
plot csv using (of("shipped", "ssim")):(row(strcol("scene"))):(column("least")):(column("most")) \
         with xerrorbars linetype 3 pointtype 9 pointsize 1.2 notitle

set lmargin at screen 0.795
set rmargin at screen 0.98
set xtics 1
set xrange [0:5]
set xlabel "twinkle"
set arrow 1 from 1,graph 0 to 1,graph 1 nohead linecolor rgb grey dashtype 2
plot csv using (of("shipped", "twinkle")):(row(strcol("scene"))) \
         with points linetype 4 pointtype 11 pointsize 1.4 notitle
unset multiplot
