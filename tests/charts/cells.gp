# SPDX-License-Identifier: MIT
# Error of a wave on a grid, and its change as the grid slides, against cells in a wavelength.
@panels
@log_x
set xrange [1.2:34]
set yrange [0:145]
set ytics 20
set xlabel "cells in a wavelength"

@first
set ylabel "error, % of the wave's rms" offset 0.5,0
set label 1 "(kd)^2 / 120^{1/2}" at 4.6,26 left textcolor rgb grey
plot csv using "cells":(column("cells") > 2.6 ? column("theory") : NaN) with lines \
         dashtype 2 linecolor rgb grey notitle, \
     "" using "cells":"unfiltered" with linespoints linetype 2 title "unfiltered", \
     "" using "cells":"filtered" with linespoints linetype 1 pointtype 7 title "filtered", \
     "" using "cells":"variance" with linespoints linetype 3 \
         title "variance to the light"

@second
unset label 1
set label 2 "change by a slide\nof half a cell" at graph 0.4,0.9 left
plot csv using "cells":"slide" with linespoints linetype 2 notitle, \
     "" using "cells":"filtered_slide" with linespoints linetype 1 pointtype 7 notitle
unset multiplot
