# SPDX-License-Identifier: MIT
# Areas: the criteria that the engine reports as met.  Lines: the criteria themselves.
# Points: waves of the shipped scenes on their way from deep water to the shore.
set logscale xy
set xrange [0.01:1]
set yrange [0.004:0.4]
set xlabel "depth in wave lengths, h/L"
set ylabel "wave height in wave lengths, H/L" offset 0.5,0
set xtics ("0.01" 0.01, "0.02" 0.02, "0.05" 0.05, "0.1" 0.1, "0.2" 0.2, "0.5" 0.5, "1" 1)
set ytics ("0.005" 0.005, "0.01" 0.01, "0.02" 0.02, "0.05" 0.05, "0.1" 0.1, "0.2" 0.2)
unset key
unset grid
set lmargin 9; set rmargin 3; set tmargin 1

# Colours by the sum of 1 for steepness, 2 for depth and 4 for Miche.
array tint[8] = [0xFFFFFF, 0xFFFFFF, 0xF6D9A8, 0xFFFFFF, 0xC6E6F8, 0x9CC3DE, 0xB4E0D0, \
                 0xD8D8D8]
area(flags) = tint[int(flags) + 1]
x_step = 100 ** (0.52 / 48)
y_step = 100 ** (0.52 / 56)
map(name) = strcol("set") eq "map" ? column(name) : NaN
path(name) = is_used(strcol("used")) ? column(name) : NaN
# A wave's name stands beside its deepest point, where no other wave's points lie.
deepest = system("awk -F, '$5 != \"-\" && NR > 1 { last[$1] = $2 } END { for (s in last) " . \
                 "printf \"%s=%s \", s, last[s] }' '" . csv . "'")
is_last(set, depth) = strstrt(" " . deepest, " " . set . "=" . depth . " ") > 0
name(y) = is_last(strcol("set"), strcol("depth")) ? path(y) : NaN
place(set) = set eq "shallows-0" ? 1 : set eq "shore-break-0" ? 2 : 3
at_(k, y) = place(strcol("set")) == k ? name(y) : NaN
whole(y)  = column("flags") == 0 ? y : NaN
broken(y) = column("flags") == 0 ? NaN : y

set style fill solid noborder
set label 1 "all three: it breaks" at 0.011,0.26 front
set label 2 "depth and Miche" at 0.0115,0.07 front
set label 3 "steepness, Miche" at 0.97,0.2 right front
set label 4 "does not break" at 0.02,0.0055 front
set label 5 "depth: H = 0.78 h" at 0.023,0.0128 rotate by 41 front \
    textcolor rgb vermillion
set label 6 "steepness: H = L / 7" at 0.011,0.168 front textcolor rgb "#8A4A75"
set label 7 "Miche: H = 0.142 L tanh kh" at 0.97,0.115 right front textcolor rgb blue
set label 8 "dots: shipped scenes' waves, hollow from where they break" \
    at 0.97,0.0085 right front

plot csv using (map("depth")):"rise":(map("depth") / x_step):(map("depth") * x_step): \
         (column("rise") / y_step):(column("rise") * y_step):(area(column("flags"))) \
         with boxxyerror linecolor rgb variable, \
     0.78 * x with lines linecolor rgb vermillion linewidth 2.4, \
     1 / 7. with lines linecolor rgb purple linewidth 2.4, \
     0.142 * tanh(2 * pi * x) with lines linecolor rgb blue linewidth 2.4, \
     csv using (path("depth")):(whole(column("rise"))) with points pointtype 7 \
         pointsize 0.9 linecolor rgb black, \
     "" using (path("depth")):(broken(column("rise"))) with points pointtype 6 \
         pointsize 0.7 linewidth 1 linecolor rgb "#404040", \
     "" using (path("depth")):(at_(1, "rise")):(strcol("set")) \
         with labels right offset 0,0.8 noenhanced, \
     "" using (path("depth")):(at_(2, "rise")):(strcol("set")) \
         with labels left offset 0.9,0.4 noenhanced, \
     "" using (path("depth")):(at_(3, "rise")):(strcol("set")) \
         with labels right offset 0,-0.8 noenhanced
