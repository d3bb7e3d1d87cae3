# SPDX-License-Identifier: MIT
# A line of the table of shipped scenes.
#
#   awk -v name=SCENE-KB -v options=TEXT -f tests/budgets/shipped-ram.awk PSNR COUNTS SAID
#
# Fails if the memory and the stack exceed the KB, or if a picture is missing or leaves
# something out.
FILENAME ~ /\.psnr$/ { split($0, word, ","); db = word[3]; next }
$1 == "count" && $3 ~ /^(frame|tiles)$/ { insns += $5 }
$1 == "frame" { frames++ }
$1 == "water" { dropped += $NF }
$1 == "ram" {
    for (i = 2; i < NF; i += 2)
        value[$i] = $(i + 1)
}
END {
    kb = name
    sub(/.*-/, "", kb)
    scene = substr(name, 1, length(name) - length(kb) - 1)
    all = value["frame"] + value["scratch"] + value["world"]
    printf "| `%s` | %d | `%s` | %d | %d | %d | %d | %d | %d | %d | %d | %.2f | %s |\n", scene,
        kb, options,
        value["frame"] - value["vertices"] - value["tables"] - value["mirror"],
        value["vertices"], value["tables"], value["mirror"], value["scratch"],
        value["world"], all, value["stack"], insns / 2e6, db == "" ? "-" : db
    if (frames != 2 || dropped || insns == 0 || !all || all + value["stack"] > kb * 1024) {
        print name ": " all " bytes and a stack of " value["stack"] ", " frames + 0 \
            " pictures, dropped " dropped + 0 >"/dev/stderr"
        exit 1
    }
}
