# SPDX-License-Identifier: MIT
# One map for each kind of cell: ticks from a drop until exact rest, over r and damping;
# with theory as contours of the same ticks, the bound on configurations, and the line
# left of which long waves creep.
of(bits) = sprintf("< awk -F, 'NR == 1 || $1 == %d { $1 = $1; print }' '%s'", bits, csv)
set datafile separator whitespace
once(r, name) = r == 0.05 ? column(name) : NaN
# Theory: a scan for each damping, as far as the water comes to rest.
grid(bits) = sprintf("< awk -F, '$1 == %d && $3 < 0.69 { if ($2 != last && last) print " . \
    "\"\"; last = $2; print $3, $2, log($5) / log(10) }' '%s'", bits, csv)
at_rest(name) = strcol("ending") eq "rests" ? column(name) : NaN

# Steps of brightness at 100, 316, 1000 ... ticks, equal to the contours of theory.
set palette maxcolors 8 defined (0 "#00204D", 0.25 "#31446B", 0.5 "#7C7B78", \
    0.75 "#BCAF6F", 1 "#FFEA46")
set cbrange [1.5:5.5]
set cbtics ("100" 2, "1000" 3, "10 000" 4, "100 000" 5) nomirror out scale 0.3 \
    offset -0.6,0

set multiplot
set xrange [0.0375:0.8625]
set yrange [3.5:10.5]
set xtics 0.2 format "%.1f"
set ytics ("1/16" 4, "1/32" 5, "1/64" 6, "1/128" 7, "1/256" 8, "1/512" 9, "1/1024" 10) \
    scale 0
unset grid
unset key
set tmargin at screen 0.80
set bmargin at screen 0.135
set label 1 "{/:Bold —} white: theory, in ticks     " . \
    "{/:Bold - -} black: no pool beyond it" at screen 0.02,0.965 left
set label 2 "{/:Bold · ·} vermillion: left of it long waves creep     " . \
    "empty: never rests" at screen 0.02,0.92 left
set label 5 "damping" at screen 0.012,0.835 left

left = 0.105; width = 0.24
do for [n = 1:3] {
    bits = 4 * 2**n
    set lmargin at screen left + (n - 1) * (width + 0.012)
    set rmargin at screen left + (n - 1) * (width + 0.012) + width
    set label 3 sprintf("%d bits", bits) at graph 0.12,1.035 left
    if (n == 2) { unset label 1; unset label 2; unset label 5; set ytics ("" 4) }
    if (n == 2) { set xlabel "r: cells that waves go in a tick;   " . \
                      "damping: share of motion that a tick takes" }
    if (n == 3) { unset xlabel; set colorbox user origin 0.862,0.135 size 0.02,0.665; \
                  set label 4 "ticks until rest" at screen 0.985,0.835 right }
    if (n < 3) { unset colorbox }
    set contour base
    set cntrparam levels incremental 2,0.5,5
    unset surface
    set datafile nocolumnheaders
    set format x "%.4f"
    set format y "%.4f"
    set table $theory
    splot grid(bits) using 1:2:3
    unset table
    set datafile columnheaders
    set format x "%.1f"
    plot of(bits) using "r":"m":(0.0128):(0.505):(log10(at_rest("ticks"))) \
             with boxxyerror fillcolor palette fillstyle solid noborder, \
         "" using (once(column("r"), "bound")):"m" with lines linecolor rgb black \
             linewidth 2.4 dashtype 2, \
         "" using (once(column("r"), "creep")):"m" with lines linecolor rgb vermillion \
             linewidth 2.4 dashtype 3, \
         $theory using 1:2 with lines linecolor rgb "white" linewidth 2.4, \
         "" using ($1 > 0.674 ? 0.71 : NaN):2:(sprintf("%.0f", 10**$3)) with labels left \
             font font . ",12" textcolor rgb "#303030"
}
unset multiplot
