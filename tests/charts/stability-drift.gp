# SPDX-License-Identifier: MIT
# One map for each kind of cell: drift of the mean height between a drop and rest, over r
# and damping; with von Neumann's line, the bound on configurations, and dots where cells
# reach the end of their range.
of(bits) = sprintf("< awk -F, 'NR == 1 || $1 == %d' '%s'", bits, csv)
once(r, name) = r == 0.05 ? column(name) : NaN

# Powers of ten; exactly 0 is white.
place(lsb) = lsb > 0 ? log10(lsb) : -4
set palette maxcolors 12 defined (0 "#FFFFFF", 0.08 "#FFFFFF", 0.0801 "#C9CFDC", \
    0.35 "#7C8299", 0.66 "#31446B", 0.67 "#D8CF9A", 0.83 "#EBCB45", 1 "#B58900")
set cbrange [-4:2]
set cbtics ("0" -3.75, "0.001" -3, "0.01" -2, "0.1" -1, "1" 0, "10" 1, "100" 2) \
    nomirror out scale 0.3 offset -0.6,0

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
set label 1 "{/:Bold —} red: von Neumann     {/:Bold - -} black: no pool beyond it" \
    at screen 0.02,0.965 left
set label 2 "white: exactly none     dots: a cell meets its range's end" \
    at screen 0.02,0.92 left
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
                  set label 4 "|mean|, LSB" at screen 0.985,0.835 right }
    if (n < 3) { unset colorbox }
    plot of(bits) using "r":"m":(0.0128):(0.505):(place(column("drift"))) \
             with boxxyerror fillcolor palette fillstyle solid noborder, \
         "" using (column("full") > 0 ? column("r") : NaN):"m" with points \
             pointtype 7 pointsize 0.25 linecolor rgb black, \
         "" using (once(column("r"), "neumann")):"m" with lines linecolor rgb vermillion \
             linewidth 2, \
         "" using (once(column("r"), "bound")):"m" with lines linecolor rgb black \
             linewidth 2.4 dashtype 2
}
unset multiplot
