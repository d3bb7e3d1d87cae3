# SPDX-License-Identifier: MIT
# Figures of one scene on the board by stage, for budgets.awk and for people.
#
#   awk -v scene=NAME [-v functions=1] -f tests/lib/symbol_at.awk \
#       -f tests/budgets/stages.awk SYMBOLS SAID COUNTS
#
# SYMBOLS is the output of nm, sorted, in decimal, with files; SAID is the board's output,
# COUNTS the plugin's counts. Prints lines
#     figure SCENE MEASURE VALUE
# per frame, or for `tick` per tick. A measure with a dot is a stage, a part of
# `instructions`: frame.X for work once per frame, tiles.X for work in tiles, with X from
# the function's file; tick.X is a part of `tick`, by module, if it is 2 % or more of a tick
# of 100,000 instructions or more. With functions=1 lists the functions instead, the largest first.
FILENAME == ARGV[1] {
    if (tolower($2) == "t" || $2 == "W") {
        start[++symbols] = $1 + 0
        called[symbols] = $3
        file[symbols] = $4
    }
    next
}
/^frame/ { frames++; next }
/^water/ { water += $2; next }
/^ram/   { for (i = 2; i < NF; i += 2) ram[$i] = $(i + 1); next }
/^count/ {
    at = symbol_at($6)
    insns[$3 " " at] += $5
    total[$3] += $5
}

# Stage of a file's functions: for shading the file's own name.
function stage_of(account, path,    folder, name)
{
    sub(/:[0-9]*$/, "", path)
    if (!match(path, /src\/[a-z]+\/([a-z_]+\/)?[^\/]*$/))
        return "helpers"                    # functions of the compiler, mem*
    path = substr(path, RSTART + 4)
    if (sub(/^features\//, "", path))       # a module: its stages, or its pass
        path = (path ~ /_stage\.[a-z]*$/ ? "shade/" : "frame/") \
            substr(path, index(path, "/") + 1)
    folder = substr(path, 1, index(path, "/") - 1)
    name = substr(path, index(path, "/") + 1)
    sub(/\.[a-z]*$/, "", name)
    if (folder == "fixed" || folder == "base" || folder == "mesh")
        return "helpers"
    if (folder == "pixel")
        return "store"
    if (account == "tiles")
        return folder == "shade" ? name : folder == "raster" || folder == "view" || \
            folder == "frame" ? "visibility" : "places"
    if (folder == "waves" || folder == "view" || folder == "pool")
        return "vertices"
    return folder == "shade" || folder == "raster" ? "pictures" : "plan"
}

# Part of a tick: the module's folder, or the folder of the models it calls.
function part_of_tick(path)
{
    sub(/:[0-9]*$/, "", path)
    if (!match(path, /src\/[a-z]+\/([a-z_]+\/)?[^\/]*$/))
        return "helpers"
    path = substr(path, RSTART + 4)
    sub(/^features\//, "", path)
    sub(/\/.*/, "", path)
    return path == "fixed" || path == "base" ? "helpers" : \
           path == "view" || path == "coastal" ? "waves" : path
}

function list_functions(    i, k, n, best, part, of)
{
    of = total["frame"] + total["tiles"]
    printf "\n%s: %.0f instructions a frame, %.1f a water pixel (of %d), a tick %.0f\n",
        scene, of / frames, of / water, water / frames, total["tick"] / frames
    printf "  %-22s %-28s %11s  share  a water pixel\n", "stage", "function", \
        "instructions"
    for (n = 0; n < 60; n++) {
        best = ""
        for (i in insns)
            if (insns[i] > 0 && (best == "" || insns[i] > insns[best]))
                best = i
        if (best == "" || insns[best] < of / 1000)
            break
        split(best, part, " ")
        if (part[1] != "tick")
            printf "  %-22s %-28s %11.0f %5.1f %% %8.1f\n", \
                part[1] "." stage_of(part[1], file[part[2]]), called[part[2]], \
                insns[best] / frames, 100 * insns[best] / of, insns[best] / water
        insns[best] = 0
    }
}

function figure(measure, format, value)
{
    printf "figure %s %s " format "\n", scene, measure, value
}

END {
    if (!frames || !water || !total["tiles"]) {
        print "FAILED - " scene ": nothing was counted"
        exit 1
    }
    if (functions) {
        list_functions()
        exit 0
    }
    figure("instructions", "%.0f", (total["frame"] + total["tiles"]) / frames)
    figure("pixel", "%.1f", (total["frame"] + total["tiles"]) / water)
    figure("tick", "%.0f", total["tick"] / frames)
    for (i in insns) {
        split(i, part, " ")
        if (part[1] != "tick")
            stage[part[1] "." stage_of(part[1], file[part[2]])] += insns[i]
        else
            ticks["tick." part_of_tick(file[part[2]])] += insns[i]
    }
    for (i in ticks)
        if (total["tick"] >= 1e5 * frames && ticks[i] >= total["tick"] / 50)
            figure(i, "%.0f", ticks[i] / frames)
    for (i in stage)
        figure(i, "%.0f", stage[i] / frames)
    figure("frame-bytes", "%d", ram["frame"])
    figure("table-bytes", "%d", ram["tables"])
    figure("scratch-bytes", "%d", ram["scratch"])
    figure("world-bytes", "%d", ram["world"])
    figure("stack-bytes", "%d", ram["stack"])
    figure("working-bytes", "%d", \
        ram["frame"] - ram["tables"] + ram["scratch"] + ram["world"])
}
