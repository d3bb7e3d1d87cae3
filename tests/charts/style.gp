# SPDX-License-Identifier: MIT
# Style of all charts; read before NAME.gp, with
#
#   csv, time_csv   NAME.csv and NAME.time.csv        out   the picture, without suffix
#   term            "svg" or "png"
#
# 900x600, with letters that stay readable at a width of 600.  Colours are from Okabe and
# Ito; each has a shape of its own, hollow (pt) and filled (pt + 1).
# A macro, @name, is the beginning of a line or whole commands; the rest are functions.

font = "DejaVu Sans"
if (term eq "svg") {
    set terminal svg size 900,600 dynamic enhanced background "white" \
        font font . ",20" linewidth 1.6
} else {
    if (strstrt(GPVAL_TERMINALS, "pngcairo") > 0) {
        set terminal pngcairo size 900,600 enhanced font font . ",15" linewidth 1.6
    } else {
        set terminal png size 900,600 enhanced font font . ",15" linewidth 1.6
    }
}
# A picture of another height and size of letters: eval sized(1100, 12)
sized(height, letters) = "set output; set terminal " . (term eq "svg" ? \
    sprintf('svg size 900,%d dynamic enhanced background "white" font "%s,%d"', \
            height, font, letters * 4 / 3) : \
    sprintf('%s size 900,%d enhanced font "%s,%d"', strstrt(GPVAL_TERMINALS, "pngcairo") \
            ? "pngcairo" : "png", height, font, letters)) . \
    ' linewidth 1.6; set output "' . out . "." . term . '"'

set output out . "." . term
set encoding utf8
set datafile separator ","
set datafile columnheaders missing NaN

# -- colours ---------------------------------------------------------------------------

blue = "#0072B2"; vermillion = "#D55E00"; green = "#009E73"; purple = "#CC79A7"
orange = "#E69F00"; sky = "#56B4E9"; yellow = "#F0E442"; black = "#000000"
grey = "#707070"; light = "#D8D8D8"
colours = "#0072B2 #D55E00 #009E73 #CC79A7 #E69F00 #56B4E9 #F0E442 #000000"
shapes  = "6 4 8 10 12 14 1 2"
set for [i=1:8] linetype i linecolor rgb word(colours, i) linewidth 2 \
    pointtype int(word(shapes, i)) pointsize 1.4
set linetype cycle 8

# Palettes that differ by brightness too (dark is low); and around a middle: blue, white,
# vermillion.
heat = 'set palette defined (0 "#00204D", 1 "#31446B", 2 "#666970", 3 "#958F78", ' . \
       '4 "#CAB969", 5 "#FFEA46")'
diverging = 'set palette defined (-1 "#0072B2", 0 "#FFFFFF", 1 "#D55E00")'

# -- axes ------------------------------------------------------------------------------

set border 3 linecolor rgb grey linewidth 1
set tics nomirror out scale 0.6 textcolor rgb "#303030"
set grid xtics ytics linetype 1 linecolor rgb light linewidth 0.6
set key at screen 0.11,0.985 left top Left reverse horizontal maxrows 1 samplen 1 width -5 noopaque
set autoscale fix
set lmargin 10; set rmargin 3; set tmargin 3.2; set bmargin 3.6

# Logarithmic axes: with 1, 2 and 5 of each decade (up to three decades), or with powers
# of ten.
count(v) = v >= 1000 ? gprintf("%.0s%c", v) : sprintf("%g", v)
ones(axis) = 'set logscale ' . axis . '; set ' . axis . 'tics (); ' . \
    'set for [e=-9:12] for [m in "1 2 5"] ' . axis . \
    'tics add (count(m * 10.0**e) m * 10.0**e)'
tens(axis) = 'set logscale ' . axis . '; set format ' . axis . ' "10^{%L}"'
log_x = ones('x'); log_y = ones('y'); decades_x = tens('x'); decades_y = tens('y')

# Two panels with a shared y axis: the first and wider for the Cortex-M4, the second for x86-64.
#     @panels
#     @first;  set xlabel "..."; plot ...
#     @second; set xlabel "..."; plot ...
#     unset multiplot
panels = 'set multiplot'
first  = 'set lmargin at screen 0.125; set rmargin at screen 0.63'
second = 'set lmargin at screen 0.68; set rmargin at screen 0.975; ' . \
         'unset ylabel; set format y ""; unset key'

# -- points ----------------------------------------------------------------------------

# True if a shipped scene uses the row, by its column "used".
is_used(u)    = u ne "" && u ne "-"

# The value of a column on matching rows; on others nothing is drawn.
front(name)  = column("front") == 1 ? column(name) : NaN
used(name)   = is_used(strcol("used")) ? column(name) : NaN
unused(name) = is_used(strcol("used")) ? NaN : column(name)

# Label of a used point: its name and its scenes.
who(u)       = u eq "all" ? "every scene" : \
               words(u) > 2 ? sprintf("%d scenes", words(u)) : u
by(name)     = strcol(name) . ": " . who(strcol("used"))

# plot csv using ...: the line of the front, points, used points filled, and their names.
front_line   = 'smooth unique with steps linecolor rgb grey linewidth 1.2'
hollow       = 'with points linecolor rgb blue pointtype 6 pointsize 1.6 linewidth 1.6'
filled       = 'with points linecolor rgb vermillion pointtype 7 pointsize 2.0'
names        = 'with labels left offset 0.7,0.6 noenhanced textcolor rgb "#303030"'
names_used   = 'with labels left offset 0.7,0.6 noenhanced textcolor rgb vermillion'
