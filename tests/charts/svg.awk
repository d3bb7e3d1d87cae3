# SPDX-License-Identifier: MIT
# Makes the points of gnuplot's SVG as large and thick as those of its PNG: gnuplot scales
# them by the height of letters, twice as large, with a thin line for each line width.
#
#   awk -f tests/charts/svg.awk FROM.svg >TO.svg
/id='gpPt[0-9]+' stroke-width='/ {
    sub(/stroke-width='[0-9.]+'/, "stroke-width='0.45'")
}
/<use .* scale\([0-9.]+\)/ {
    match($0, /scale\([0-9.]+\)/)
    size = substr($0, RSTART + 6, RLENGTH - 7)
    $0 = substr($0, 1, RSTART + 5) sprintf("%.2f", 0.46 * size) \
         substr($0, RSTART + RLENGTH - 1)
}
{ print }
