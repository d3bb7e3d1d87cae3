# SPDX-License-Identifier: MIT
# Contents of the frames and callgrind's two lists of functions, as a readable table. An
# inlined function counts for its caller.
#
#   awk -v size=WxH -f tests/budgets/host.awk HELD LISTS
$1 == "held" { frames++; water += $3; vertices += $5; next }
$1 == "inclusive" && $3 ~ /^[0-9,]+$/ && match($0, /\) +[^ ]*:[A-Za-z_][A-Za-z0-9_.]*/) {
    name = substr($0, RSTART, RLENGTH)
    sub(/.*:/, "", name)
    gsub(/,/, "", $3)
    if ($2 == "no") {
        if (!(name in insns))
            order[++names] = name
        insns[name] += $3
        total += $3
    } else if (name == "tp_frame_begin" && $3 > begin)
        begin = $3
}
END {
    if (!total || !water) {
        print "callgrind counted nothing"
        exit 1
    }
    printf "\n%s on this machine: %d instructions a frame, %.1f a water pixel (of %d)\n",
        size, total / frames, total / water, water / frames
    printf "  once a frame: %d, %.1f a vertex (of %d); ",
        begin / frames, begin / vertices, vertices / frames
    printf "in tiles: %d, %.1f a water pixel\n",
        (total - begin) / frames, (total - begin) / water
    print "  function                     instructions   share  a water pixel"
    for (shown = 1; shown <= names; shown++) {
        best = ""
        for (name in insns)
            if (best == "" || insns[name] > insns[best])
                best = name
        if (insns[best] < total / 200)
            break
        printf "  %-28s %11d %5.1f %% %8.1f\n", best, insns[best] / frames,
            100 * insns[best] / total, insns[best] / water
        delete insns[best]
    }
}
