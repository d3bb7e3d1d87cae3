# SPDX-License-Identifier: MIT
# A line for each scene: points are the measured errors of its cameras, the bar the
# predicted error.  A point right of the bar broke the plan's bound.
scenes = system("tail -n +2 " . csv . " | cut -d, -f1 | uniq")
at(name) = sum [i=1:words(scenes)] (word(scenes, i) eq name ? i : 0)
set yrange [words(scenes) + 0.7:0.3]
set ytics ()
do for [i=1:words(scenes)] { set ytics add (word(scenes, i) i) }
set xrange [-0.15:*]
set offsets 0, 0.3, 0, 0
set xtics 1
set grid xtics linecolor rgb light
set xlabel "colour error beyond that of the exact rungs, rms levels"
set lmargin 14
set key at screen 0.17,0.985 maxrows 1 width -6
broken = 'column("colour") > column("predicted") + 0.001'
plot csv using (column("predicted") / 2):(at(strcol("scene"))):(column("predicted") / 2):(0.3) \
         with boxxyerror linecolor rgb light fillstyle solid title "predicted", \
     "" using (@broken ? NaN : column("colour")):(at(strcol("scene"))) with points \
         pointtype 6 pointsize 1.2 linecolor rgb blue title "measured", \
     "" using (@broken ? column("colour") : NaN):(at(strcol("scene"))) with points \
         pointtype 7 pointsize 1.2 linecolor rgb vermillion \
         title "beyond its bar"
