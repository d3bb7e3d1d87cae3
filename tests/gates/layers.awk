# SPDX-License-Identifier: MIT
# Includes point to lower ranks.
#
#   awk -f tests/gates/layers.awk include/tidepool/*.h src/*/* ports/*/*.[ch]
#
# Ranks from low to high; modules on one line are peers and do not include each other. A
# public header has the rank of the module that implements it; `types` names the lower
# modules that may include a header for its types. A public header may include the headers
# before it in their order.
#
# app, tools, linuxfb, kms, null and library may include all headers of src. Other ports
# include the public headers and their own, and from src those named in `grants`:
#   rpi, cortex-m, pico
#                   share one block of memory (base.h), print a picture's checksum (pixel.h),
#                   count pixels of water (tools.h), write buttons as a tape (text.h)
#   serial          a serial line has the tape's format, and sets rows by text (text.h)
#   interact        keeps a world's state over a change (world.h, exposure.h), and finds
#                   the water under a pixel (pools.h, drops.h, arithmetic.h)
#   web             reads OBJ in pieces (mesh.h), has a governor (tools.h), keeps the camera
#                   of a world that it makes again (world.h)
# The templates of new-board call the panel driver lcd, and cortex-m for a checksum.
# The raw screens linuxfb and kms are driven by app/fullscreen. The input and the changes of
# interact are for all interactive ports. The host library, in ports/library, offers parts
# of app and interact to other programs. A program's own modules, in ports/examples, include
# the same headers as the library's modules; TP_MORE names the header that lists such
# modules.
BEGIN {
    levels = split("base|fixed|pixel|mesh waves pool|view|raster shade|world|quality|" \
                   "frame|features|engine", level, "|")
    for (i = 1; i <= levels; i++) {
        n = split(level[i], module, " ")
        for (j = 1; j <= n; j++)
            rank[module[j]] = i
    }
    split("fixed=base status=base assets=mesh modules=pixel scene=world " \
          "tidepool=engine", special, " ")
    for (i in special) {
        split(special[i], pair, "=")
        owner[pair[1]] = pair[2]
    }
    split("base=tidepool pixel=frame waves=scene waves=assets waves=world pool=scene " \
          "pool=assets view=world", types, " ")
    for (i in types)
        typed[types[i]]
    split("app tools linuxfb kms null library", tools, " ")
    for (i in tools)
        tool[tools[i]]
    split("rpi=base/base.h rpi=pixel/pixel.h cortex-m=base/base.h " \
          "cortex-m=pixel/pixel.h cortex-m=frame/tools.h cortex-m=world/text.h " \
          "pico=base/base.h pico=pixel/pixel.h pico=frame/tools.h pico=world/text.h " \
          "serial=base/base.h serial=world/text.h " \
          "serial=world/pools.h serial=features/drops/drops.h " \
          "interact=fixed/arithmetic.h interact=world/text.h interact=world/world.h " \
          "interact=world/pools.h interact=features/drops/drops.h " \
          "interact=features/exposure/exposure.h " \
          "interact=features/foam/foam_visit.h interact=waves/coastal_tables.h " \
          "interact=quality/plan.h interact=quality/rung_sets.h " \
          "web=mesh/mesh.h web=base/base.h web=world/text.h web=world/world.h " \
          "web=frame/tools.h " \
          "web=pixel/pixel.h web=world/pools.h web=features/drops/drops.h", grants, " ")
    for (i in grants)
        granted[grants[i]]
    n = split("fixed status scene assets world frame modules tidepool", public_header, " ")
    for (i = 1; i <= n; i++)
        place[public_header[i]] = i
    split("stddef.h stdint.h stdbool.h limits.h", system_header, " ")
    for (i in system_header)
        free[system_header[i]]
    split("app=tools tools=app app=interact app=cortex-m null=app kms=app linuxfb=app " \
          "serial=interact rpi=serial rpi=interact cortex-m=serial cortex-m=lcd web=interact " \
          "pico=serial pico=lcd pico=cortex-m new-board=lcd new-board=cortex-m " \
          "library=app library=interact", sights, " ")
    for (i in sights)
        guest[sights[i]]
}

# Module of a public header, by its name without folder and ".h".
function module_of(name)
{
    sub(/\.h$/, "", name)
    return name in owner ? owner[name] : name
}

function wrong(why)
{
    printf "%s:%d: %s: %s\n", FILENAME, FNR, why, $0
    bad = 1
}

FNR == 1 {
    n = split(FILENAME, part, "/")
    file = part[n]
    tree = folder = ""
    for (i = 1; i < n; i++)
        if (part[i] ~ /^(include|src|ports)$/) {
            tree = part[i]
            folder = part[i + 1]
        }
    here = tree == "include" ? module_of(file) : folder
    if (tree == "src" && !(here in rank))
        wrong("folder without a rank")
}

/^[ \t]*#[ \t]*include[ \t]+TP_MORE/ { next }

/^[ \t]*#[ \t]*include/ {
    name = $0
    sub(/^[^<"]*[<"]/, "", name)
    sub(/[>"].*/, "", name)
    split(name, step, "/")
    public = step[1] == "tidepool"
    if (tree == "ports") {
        if ($0 ~ /</ && !public)
            next                                    # a system header
        if (step[1] == "..")
            step[1] = step[2]
        if (step[1] in rank && (folder in tool || (folder "=" name) in granted))
            next
        sight = folder "=" step[1]
        if (public || name !~ /\// || step[1] == folder || sight in guest \
            || (FILENAME ~ /examples\/buoy\// && step[1] in rank && step[1] != "features"))
            next
        wrong("a port includes public headers and its own alone")
    } else if ($0 ~ /</) {
        if (!(name in free) && !(name == "arm_acle.h" && FILENAME ~ /base\/dsp\.h$/))
            wrong("the core is freestanding")
    } else {
        there = public ? module_of(step[2]) : step[1]
        if (tree == "include") {
            name = step[2]
            sub(/\.h$/, "", name)
            self = file
            sub(/\.h$/, "", self)
            if (!public)
                wrong("a public header includes public headers alone")
            else if (!(name in place) || place[name] >= place[self])
                wrong("a public header includes those before it alone")
            next
        }
        title = step[2]
        sub(/\.h$/, "", title)
        if (public && (here "=" title) in typed)
            next
        if (!(there in rank))
            wrong("no such module")
        else if (rank[there] > rank[here] || (rank[there] == rank[here] && there != here))
            wrong(here " may not see " there)
    }
}

END { exit bad }
