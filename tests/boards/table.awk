# SPDX-License-Identifier: MIT
# Tables of boards and scenes, in Markdown.
#
#   awk -v from=FOLDER -f tests/boards/table.awk SHOTS
#
# SHOTS has lines BOARD/SCENE. FOLDER has for each the output of `size -A` (.size), the
# board's output (.said), the plugin's counts (.counts) and the bytes sent to a display
# (.sent).
BEGIN {
    FS = "/"
    memory = "| board, scene | frame | water | mirror | tile | world | in all | stack |\n" \
        "|---|---|---|---|---|---|---|---|\n"
    work = "| board, scene | picture, tiles | code | constants | scene | instructions | sent" \
        " |\n|---|---|---|---|---|---|---|\n"
}

function look(file,    line, word, n, i)
{
    while ((getline line < file) > 0) {
        n = split(line, word, " ")
        if (word[1] ~ /^\./)
            size[word[1]] = word[2]
        else if (word[1] == "frame")
            frames++
        else if (word[1] == "ram")
            for (i = 2; i < n; i += 2)
                value[word[i]] = word[i + 1]
        else if (word[1] == "sent")
            value["sent"] = word[2]
        else if (word[1] == "picture")
            picture = word[2] " " word[3] ", " word[4]
        else if (word[1] == "count" && word[3] ~ /^(frame|tiles)$/)
            insns += word[5]
    }
    close(file)
}

{
    frames = insns = 0
    split("", size)
    split("", value)
    look(from "/" $0 ".size")
    look(from "/" $0 ".said")
    look(from "/" $0 ".counts")
    look(from "/" $0 ".sent")
    if (!value["sent"] || !frames || !insns || !size[".text"] || !value["frame"]) {
        print "FAILED - " $0 ": nothing was measured"
        failed = 1
        exit 1
    }
    all = value["frame"] + value["scratch"] + value["panel"] + value["world"] \
        + size[".data"] + size[".bss"]
    memory = memory sprintf("| %s, `%s` | %d | %d | %d | %d | %d | %d | %d |\n", $1, $2,
        value["frame"] - value["vertices"] - value["mirror"], value["vertices"],
        value["mirror"], value["scratch"] + value["panel"], value["world"], all,
        value["stack"])
    work = work sprintf("| %s, `%s` | %s | %d | %d | %d | %d | %d |\n", $1, $2, picture,
        size[".text"], size[".rodata"] + size[".exidx"], size[".baked"],
        insns / frames, value["sent"])
}

END {
    if (failed)
        exit 1
    printf "%s\n%s", memory, work
}
