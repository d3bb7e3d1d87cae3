# SPDX-License-Identifier: MIT
# One map for each kind of cell: growth of noise per tick, over r and damping; with von
# Neumann's line, the bound on configurations, the line of noise, and dots where cells
# reach the end of their range.
of(bits) = sprintf("< awk -F, 'NR == 1 || $1 == %d' '%s'", bits, csv)
once(r, name) = r == 0.05 ? column(name) : NaN

# Percent a tick, on a signed logarithmic scale from tenths to hundreds: dark decays,
# bright grows.
place(p) = sgn(p) * log10(1 + abs(p) / 0.02)
set palette defined (-1 "#00204D", -0.45 "#31446B", -0.05 "#8f9bb3", 0 "#ffffff", \
    0.05 "#d8cf9a", 0.5 "#EBCB45", 1 "#B58900")
set cbrange [-3.8:3.8]
set cbtics ("0" 0) nomirror out scale 0.3 offset -0.6,0
set for [p in "0.1 1 10 100"] cbtics add ("+" . p . " %%" place(p + 0))
set for [p in "0.1 1 10"] cbtics add ("−" . p . " %%" place(-p))

set multiplot
set xrange [0.04375:0.86875]
set yrange [0.5:10.5]
set xtics 0.2 format "%.1f"
set ytics ("1/2" 1, "1/4" 2, "1/8" 3, "1/16" 4, "1/32" 5, "1/64" 6, "1/128" 7, \
    "1/256" 8, "1/512" 9, "1/1024" 10) scale 0
unset grid
unset key
set tmargin at screen 0.80
set bmargin at screen 0.135
set label 1 "{/:Bold —} white: von Neumann, beyond it waves grow     " . \
    "{/:Bold - -} black: no pool beyond it" at screen 0.02,0.965 left
set label 2 "{/:Bold · ·} vermillion: left of it rounding feeds the water     " . \
    "dots: a cell meets its range's end" at screen 0.02,0.92 left

left = 0.105; width = 0.24
do for [n = 1:3] {
    bits = 4 * 2**n
    set lmargin at screen left + (n - 1) * (width + 0.012)
    set rmargin at screen left + (n - 1) * (width + 0.012) + width
    set label 3 sprintf("%d bits", bits) at graph 0.12,1.035 left
    if (n == 1) { set label 5 "damping" at screen 0.012,0.835 left }
    if (n == 2) { unset label 5; set format y ""; set xlabel "r: cells that waves go in a tick;   damping: share of motion that a tick takes" }
    if (n == 2) { unset label 1; unset label 2; set ytics ("" 1) }
    if (n == 3) { unset xlabel; set colorbox user origin 0.862,0.135 size 0.02,0.665; \
                  set label 4 "growth a tick" at screen 0.985,0.835 right }
    if (n < 3) { unset colorbox }
    plot of(bits) using "r":"m":(place(column("growth"))) with image pixels, \
         "" using (column("full_at") > 0 ? column("r") : NaN):"m" with points \
             pointtype 7 pointsize 0.25 linecolor rgb black, \
         "" using (once(column("r"), "neumann")):"m" with lines linecolor rgb "white" \
             linewidth 4, \
         "" using (once(column("r"), "neumann")):"m" with lines linecolor rgb black \
             linewidth 1, \
         "" using (once(column("r"), "bound")):"m" with lines linecolor rgb black \
             linewidth 2.4 dashtype 2, \
         "" using (once(column("r"), "noise")):"m" with lines linecolor rgb vermillion \
             linewidth 2.4 dashtype 3
}
unset multiplot
