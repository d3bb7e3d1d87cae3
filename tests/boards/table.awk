# SPDX-License-Identifier: MIT
# Rows of tests/boards/configurations.csv, of programs that were measured.
#
#   awk -v from=FOLDER -f tests/boards/table.awk SHOTS
#
# SHOTS has lines BOARD/SCENE. FOLDER has for each the output of `size -A` (.size), the
# uses of the baked file's head (.head), the board's output (.said), the plugins' counts
# (.counts) and the bytes sent to a display (.sent).
BEGIN { FS = "/" }

function look(file,    line, word, n, i)
{
    while ((getline line < file) > 0) {
        n = split(line, word, " ")
        if (word[1] ~ /^\./)
            size[word[1]] = word[2]
        else if (word[1] == "frame" && file ~ /[.]said$/)
            frames++
        else if (word[1] == "ram" || word[1] == "sent")
            for (i = 2 - (word[1] == "sent"); i < n; i += 2)
                value[word[i]] = word[i + 1]
        else if (word[1] == "picture")
            picture = word[2] "," word[3] "," word[4]
        else if (word[1] == "count" && word[3] ~ /^(frame|tiles)$/)
            instructions += word[5]
        else if (word[1] == "cycles" && word[2] ~ /frame|tiles/)
            cycles += word[5]
        else if (file ~ /[.]head$/)
            head[word[1]] = word[2]
    }
    close(file)
}
function fail(why)
{
    print "FAILED - " $0 ": " why
    exit failed = 1
}

{
    frames = instructions = cycles = 0
    split("", size)
    split("", value)
    split("", head)
    look(from "/" $0 ".size")
    look(from "/" $0 ".head")
    look(from "/" $0 ".said")
    look(from "/" $0 ".counts")
    look(from "/" $0 ".sent")
    if (!value["sent"] || !frames || !instructions || !size[".text"] || !value["frame"])
        fail("nothing was measured")
    parts = head["frame"] + head["vertices"] + head["tables"] + head["mirror"]
    if (parts != value["frame"] || head["tile"] != value["scratch"] ||
            head["world"] != value["world"])
        fail("bake said another RAM: " parts)
    if (head["scene"] + head["pictures"] > size[".baked"] + 8 ||
            head["scene"] + head["pictures"] < size[".baked"] - 8)
        fail("bake said another scene")
    printf "%s,%s,1,%s,%d,%d,%d,%d,%d,%d,%d,%d,%d,%d,%d,%d,%d,%d,%d\n", $1, $2, picture,
        size[".text"], size[".rodata"] + size[".exidx"], head["scene"], head["pictures"],
        head["frame"], head["vertices"], head["tables"], head["mirror"], head["tile"],
        head["world"], value["panel"] + size[".data"] + size[".bss"], value["stack"],
        instructions / frames, cycles / frames, value["sent"]
}
