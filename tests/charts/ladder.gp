# SPDX-License-Identifier: MIT
# A panel for each scene: the steps of its ladder as a line, from the exact picture down.  Pictures closer than 60 dB are drawn at 60.
eval sized(1100, 12)

scenes = system("awk -F, 'NR > 1 && !seen[$1]++ { print $1 }' '" . csv . "'")
most = 60
is_step(s) = strlen(s) < 3
is_of(s, kind) = strcol("scene") eq s && \
    (kind eq "step" ? is_step(strcol("step")) : strcol("step") eq kind)
cost(s, kind) = is_of(s, kind) ? column("m4") / 1e6 : NaN
error(s, kind) = !is_of(s, kind) ? NaN : column("db") > most ? most : column("db")

columns_ = 4; rows_ = 5
left(i) = 0.07 + 0.235 * (i % columns_)
top(i) = 0.975 - 0.193 * (i / columns_)
unset key
set multiplot
set logscale x
set xrange [2.5:250]
set yrange [18:62]
set xtics ("3" 3, "10" 10, "30" 30, "100" 100)
set ytics 20,10
set object 1 rectangle from graph 0, first 18 to graph 1, first 28 behind \
    fillcolor rgb "#F4F4F4" fillstyle solid noborder
do for [i=1:words(scenes)] {
    s = word(scenes, i)
    set lmargin at screen left(i - 1)
    set rmargin at screen left(i - 1) + 0.205
    set tmargin at screen top(i - 1)
    set bmargin at screen top(i - 1) - 0.148
    set label 1 s at graph 0.04,0.93 noenhanced textcolor rgb black
    plot csv using (cost(s, "step")):(error(s, "step")) with linespoints linecolor rgb blue \
             linewidth 1.2 pointtype 7 pointsize 0.45, \
         28 with lines linecolor rgb grey linewidth 0.9 dashtype 2, \
         csv using (cost(s, "0")):(error(s, "0")) with points linecolor rgb black \
             pointtype 6 pointsize 1.3, \
         csv using (cost(s, "stm32f405")):(error(s, "stm32f405")) with points \
             linecolor rgb vermillion pointtype 7 pointsize 1.2, \
         csv using (cost(s, "cheapest")):(error(s, "cheapest")) with points \
             linecolor rgb green pointtype 9 pointsize 1.4
}
# The key, in the place of the next panels.
i = words(scenes)
unset object 1
unset border
unset tics
unset grid
set lmargin at screen left(i)
set rmargin at screen 0.98
set tmargin at screen top(i)
set bmargin at screen top(i) - 0.148
unset logscale x
set xrange [0:10]
set yrange [0:10]
set label 1 "M instructions of a Cortex-M4 (across), dB to the exact picture (up)" \
    at graph 0,0.02 textcolor rgb "#303030"
set label 2 "steps of tidepool plan --ladder, the plan's costs" at 0.5,8.9
set label 3 "first step: exact (drawn at 60 dB), or as the scene names it" at 0.5,7.3
set label 4 "stm32f405, 10 pictures a second, or its best" at 0.5,5.7
set label 5 "cheapest.txt, counted" at 0.5,4.1
set label 6 "28 dB, which the cheapest rungs keep" at 0.5,2.5
set arrow 1 from -0.15,8.9 to 0.3,8.9 nohead linecolor rgb blue linewidth 1.6
set arrow 2 from -0.15,2.5 to 0.3,2.5 nohead linecolor rgb grey linewidth 1.2 dashtype 2
plot '+' using (0.08):(7.3):(0) every ::0::0 with points linecolor rgb black pointtype 6 pointsize 1.3, \
     '+' using (0.08):(5.7) every ::0::0 with points linecolor rgb vermillion pointtype 7 pointsize 1.2, \
     '+' using (0.08):(4.1) every ::0::0 with points linecolor rgb green pointtype 9 pointsize 1.4, \
     '+' using (0.08):(8.9) every ::0::0 with points linecolor rgb blue pointtype 7 pointsize 0.6
unset multiplot
