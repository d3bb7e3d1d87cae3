# SPDX-License-Identifier: MIT
# A line for each scene, two panels for the budgets: percent above the cheapest set, a point
# for each size of the picture: 160x120 above, 320x240 on the line, 640x480 below.
eval sized(760, 13)
scenes = system("awk -F, 'NR > 1 && !seen[$1]++ { print $1 }' '" . csv . "'")
row(s) = sum [i=1:words(scenes)] (word(scenes, i) eq s ? i : 0)
sizes = "160x120 320x240 640x480"
shift_(z) = sum [i=1:3] (word(sizes, i) eq z ? 0.25 * (i - 2) : 0)
at = '(row(strcol("scene")) + shift_(strcol("size")))'
off(of, budget) = column("budget") == budget ? column(of) : NaN
set yrange [words(scenes) + 0.6:0.4]
set ytics ()
set for [i=1:words(scenes)] ytics add (word(scenes, i) i)
set ytics noenhanced
set tmargin at screen 0.83
set bmargin at screen 0.09
set key at screen 0.13,0.99 vertical maxrows 4 width -1
set xlabel "% above the cheapest set"
set multiplot
do for [panel=0:1] {
    budget = panel ? 6 : 2
    set xrange [-0.5:panel ? 62 : 10]
    set label 1 sprintf("budget: %d levels rms", budget) at graph 0.5,1.03 center
    set lmargin at screen panel ? 0.535 : 0.145
    set rmargin at screen panel ? 0.98 : 0.50
    if (panel) { set format y ""; unset key; unset ytics
        set ytics nomirror out format "" 1,1,words(scenes) }
    set arrow 1 from 5,graph 0 to 5,graph 1 nohead linecolor rgb grey dashtype 2 back
    plot csv using (off("walk_off", budget)):@at with points linetype 2 pointtype 7 \
             pointsize 1.2 title "the walk", \
         "" using (off("single_off", budget)):@at with points linetype 1 pointtype 4 \
             pointsize 1.2 title "then single changes", \
         "" using (off("plan_off", budget)):@at with points linetype 8 pointtype 2 \
             pointsize 0.8 title "the plan: two walks, changes, exchanges"
}
unset multiplot
