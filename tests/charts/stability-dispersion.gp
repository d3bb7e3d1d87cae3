# SPDX-License-Identifier: MIT
# Errors of the approximations of k: lines are the formulas, points the engine's fixed
# point.
set logscale x
@decades_y
set yrange [3e-11:3]
set xlabel "kh, depth times wave number"
set ylabel "relative error of k" offset 0.5,0
set xtics ("0.01" 0.01, "0.1" 0.1, "1" 1, "10" 10)
set mxtics 10
unset key
set lmargin 9; set rmargin 3; set tmargin 1
name(i) = word("eckart fenton newton exact hunt deep shallow", i)
array type[7] = [1, 2, 3, 4, 5, 6, 8]
array said[7] = ["Eckart", "Fenton and McKee", "Eckart and one Newton step", \
                 "and three steps", "Hunt", "deep: k = k_∞", "shallow: k = √(k_∞ / h)"]
array label_x[7] = [1.58, 4.47, 0.0708, 0.0224, 0.794, 0.0708, 0.0708]
array label_y[7] = [0.9, 1.6, -0.9, -1.2, -0.3, -0.9, 1.9]
array label_dx[7] = [4, 2, 12, 2, 3.4, 0, -4]
curve(i) = i == 4 ? "exact" : name(i) . "_theory"
at_x(i, y) = abs(column("kh") / label_x[i] - 1) < 0.04 ? column(y) : NaN
positive(y) = column(y) > 0 ? column(y) : NaN

plot for [i in "1 2 3 5 6 7"] csv using "kh":(positive(name(int(i)) . "_theory")) \
         with lines linetype type[int(i)], \
     for [i=1:4] "" using "kh":(positive(name(i))) with points linetype i pointsize 0.9, \
     for [i=1:7] "" using "kh":(at_x(i, curve(i))):(said[i]) \
         with labels offset label_dx[i],label_y[i] textcolor linetype type[i], \
     "" using "kh":(used("exact")) @filled, \
     "" using "kh":(used("exact")):(who(strcol("used"))) with labels rotate by 30 right \
         offset -0.5,-0.6 noenhanced textcolor rgb vermillion
