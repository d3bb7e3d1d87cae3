# SPDX-License-Identifier: MIT
# Reads lines "insns x y z heading pitch water", sorted; prints the cost of the dearest
# view over the median, and the place of that view.
#
#   awk -v most=MEDIANS -f tests/bench/views.awk VIEWS
{ insns[NR] = $1; line[NR] = $0 }

function show(what, k,    f)
{
    split(line[k], f, " ")
    printf "%-8s %7.2f M, %5.0f a water pixel of %d; camera.x=%s y=%s z=%s " \
           "heading=%s pitch=%s\n", what, f[1] / 1e6, f[1] / f[7], f[7], f[2], f[3], f[4],
           f[5], f[6]
}

END {
    if (!NR) {
        print "no view was counted"
        exit 1
    }
    middle = int((NR + 1) / 2)
    ratio = insns[NR] / insns[middle]
    printf "%d views, worst %.2f medians, 99 of 100 below %.2f\n", NR, ratio,
        insns[int(NR * 0.99 + 0.5)] / insns[middle]
    show("median", middle)
    show("worst", NR)
    exit ratio > most
}
