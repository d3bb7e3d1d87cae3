# SPDX-License-Identifier: MIT
# One line a scene: difference of the plan's prediction from the counted cost; the band is
# 10 % to each side. Beside the names: the counted cost.
set xrange [-15:15]
set yrange [*:*] reverse
set offsets 0, 0, 0.7, 0.7
set xtics 5
set grid xtics linecolor rgb light
set xlabel "predicted over counted instructions, %"
set lmargin 24
unset key
set object 1 rectangle from first -10, graph 0 to first 10, graph 1 behind \
    fillcolor rgb "#ECECEC" fillstyle solid noborder
off = '(100 * column("predicted") / column("counted") - 100)'
plot csv using (@off):0:(0):yticlabels( \
         sprintf("%s, %.0f M", strcol("scene"), column("counted") / 1e6)) with points linecolor rgb blue \
         pointtype 7 pointsize 1.6, \
     csv using (0):0:(@off):(0) with vectors nohead linecolor rgb blue
