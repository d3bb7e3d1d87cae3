# SPDX-License-Identifier: MIT
# A row of tests/boards/configurations.csv: the mean of frames 60 and 61 of a program of
# ports/pico.
#
#   awk -v scene=NAME -v cores=N -v format=FORMAT -v tiles=WxH -f tests/boards/pico.awk \
#       SIZE HEAD SAID
#
# SIZE is the output of `size -A`, HEAD lines USE BYTES of the baked file, SAID the output of
# run.js.  Cycles are those of the picture's begin and of the busier core's tiles.
FNR == 1 { file++ }
file == 1 && /^\./ { size[$1] = $2; next }
file == 2 { head[$1] = $2; next }
file < 3 { next }
$1 == "frame" { frame = $2 }
$1 == "cycles" && frame <= 61 {
    cycles += $3 + ($6 > $7 ? $6 : $7)
    n++
}
$1 == "instructions" && frame <= 61 { instructions += $3 + $4 + $6 + $7 }
$1 == "stack" { stack += $3 }
$1 == "ram" {
    for (i = 2; i < NF; i += 2)
        value[$i] += $(i + 1)
}
/bytes sent/ {
    sub(/.*bytes sent /, "")
    sent = $1 + 0
}
END {
    parts = head["frame"] + head["vertices"] + head["tables"] + head["mirror"]
    if (n != 2 || !sent || value["frame"] != parts || value["world"] != head["world"] ||
            value["scratch"] != cores * head["tile"]) {
        print "bake said another RAM, or nothing was measured: " parts
        exit 1
    }
    printf "pico,%s,%d,320x240,%s,%s,%d,%d,%d,%d,%d,%d,%d,%d,%d,%d,%d,%d,%d,%d,%d\n", scene,
        cores, format, tiles,
        size[".boot2"] + size[".start"] + size[".text"] + size[".data"],
        size[".rodata"] + size[".exidx"], head["scene"], head["pictures"], head["frame"],
        head["vertices"], head["tables"], head["mirror"], value["scratch"], value["world"],
        size[".data"] + size[".bss"] + value["panel"], stack, instructions / n, cycles / n,
        sent
}
