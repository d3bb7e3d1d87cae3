# SPDX-License-Identifier: MIT
# Two bars for each scene, split into modules: above, a tick of the scene as it is shipped;
# below, at its cheapest rungs (SCENE+cheap).  Diamonds: the plan's estimate; hollow: at all
# rungs of the world that the plan names (SCENE+world).  Lines: what an stm32f405 (129 M instructions a
# second) can spend on each of 60 ticks a second, all of it and a half.
scenes = system("awk -F, 'NR > 1 && $1 !~ /[+]/ && !n[$1]++ { print $1 }' '" . csv . "'")
count_ = words(scenes)
plus(s) = strstrt(s, "+")
plain(s) = plus(s) ? s[1:plus(s) - 1] : s
row(s) = sum [i=1:count_] (word(scenes, i) eq plain(s) ? count_ - i : 0)
low(s) = row(s) + (plus(s) ? -0.38 : 0.02)
high(s) = low(s) + 0.36
parts = "foam pool waves rest"
is_rest(p) = p ne "foam" && p ne "pool" && p ne "waves" && p ne "all"
planned(world) = strcol("part") eq "all" && (strstrt(strcol("scene"), "+world") > 0) == world \
                 ? column("predicted") / 1e6 : NaN
middle(s) = low(s) + 0.18
of(k) = (strcol("part") eq word(parts, k) || k == 4 && is_rest(strcol("part"))) \
        ? column("from") / 1e6 : NaN
set lmargin 13
set tmargin 3.8
set key maxrows 2 width -2
set yrange [-0.7:count_ - 0.3]
set ytics ()
set for [i=1:count_] ytics add (word(scenes, i) count_ - i)
set xrange [0:*]
set offsets 0, 0.4, 0, 0
set xlabel "Cortex-M4 instructions of a tick, millions"
set style fill solid 0.9 noborder
set arrow 1 from 2.15,graph 0 to 2.15,graph 1 nohead linecolor rgb grey dashtype 2 front
set arrow 2 from 1.075,graph 0 to 1.075,graph 1 nohead linecolor rgb grey dashtype 3 front
set label 1 "all of an stm32f405" at 2.2,graph 0.97 left textcolor rgb grey
set label 2 "half" at 1.05,graph 0.97 right textcolor rgb grey
set label 3 "upper bars: as shipped" at 2.4,7.5 left textcolor rgb grey
set label 4 "lower bars: at the cheapest rungs" at 2.4,6.5 left textcolor rgb grey
plot for [k=1:4] csv using (of(k)):(row(strcol("scene"))):(column("from") / 1e6): \
         (column("to") / 1e6):(low(strcol("scene"))):(high(strcol("scene"))) \
         with boxxyerror linetype k title word(parts, k), \
     csv using (planned(0)):(middle(strcol("scene"))) with points linecolor rgb black \
         pointtype 13 pointsize 0.8 title "the plan", \
     csv using (planned(1)):(middle(strcol("scene"))) with points linecolor rgb black \
         pointtype 12 pointsize 1.1 title "at all world rungs"
