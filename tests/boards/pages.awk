# SPDX-License-Identifier: MIT
# Tables of pages, in Markdown, from boards.csv and configurations.csv.
#
#   awk -v table=boards|configurations|ram|flash|brief|cores -f tests/boards/pages.awk \
#       tests/boards/boards.csv tests/boards/configurations.csv
#
# A row of each table but the first is a row of configurations.csv; the brief one leaves out
# one core of two.
function heads(text,    n, i, line)
{
    print "| " text " |"
    n = split(text, line, " [|] ")
    for (i = 1; i <= n; i++)
        printf "|---"
    print "|"
}
BEGIN {
    FS = ","
    head["boards"] = "board | chip | MHz | flash, KB | RAM, KB | display"
    head["configurations"] = "board, scene | picture | tiles | cores | bytes sent"
    head["ram"] = "board, scene | frame | vertices | tables | mirror | tiles | world |" \
        " program | stacks | in all"
    head["flash"] = "board, scene | code | constants | scene | pictures |" \
        " M instructions | M cycles | cycles by | pictures a second"
    head["brief"] = "board, scene | picture | RAM, KB | flash, KB |" \
        " M instructions a picture | pictures a second"
    head["cores"] = "scene | cores | ms a picture | M cycles | RAM, KB | flash, KB |" \
        " stacks, bytes"
    heads(head[table])
}
/^#/ { next }
$1 == "board" {                 # names of the columns
    split("", column)
    for (i = 1; i <= NF; i++)
        column[$i] = i
    configured = "cores" in column
    next
}
function cell(name)
{
    return $column[name]
}
# A number with a comma before each three digits.
function long(n)
{
    n = sprintf("%d", n)
    while (match(n, /[0-9][0-9][0-9][0-9]($|,)/))
        n = substr(n, 1, RSTART) "," substr(n, RSTART + 1)
    return n
}
!configured {
    mhz[$1] = cell("mhz")
    factor[$1] = cell("cycles")
    if (table == "boards") {
        display = cell("display")
        gsub(/[:;]/, ",", display)
        printf "| %s | %s | %d | %d | %d | %s |\n", $1, cell("chip"), cell("mhz"),
            cell("flash"), cell("ram"), display
    }
    next
}
{
    label = $1 ", " ($1 != "pico" ? "" : cell("cores") == 1 ? "1 core, " : \
        cell("cores") " cores, ") "`" cell("scene") "`"
    counted = factor[$1] == "counted"
    cycles = counted ? cell("cycles") : cell("instructions") * factor[$1]
    speed = mhz[$1] * 1e6 / cycles
    ram = 0
    for (use in uses)
        ram += cell(uses[use])
    flash = cell("code") + cell("constants") + cell("scene_bytes") + cell("pictures")
}
BEGIN {
    split("frame vertices tables mirror tile world program stack", uses, " ")
}
table == "configurations" {
    printf "| %s | %s %s | %s | %d | %d |\n", label, cell("picture"), cell("format"),
        cell("tiles"), cell("cores"), cell("sent")
}
table == "ram" {
    printf "| %s |", label
    for (i = 1; i <= 8; i++)
        printf " %d |", cell(uses[i])
    printf " %d |\n", ram
}
table == "flash" {
    printf "| %s | %d | %d | %d | %d | %.2f | %.2f | %s | %.1f |\n", label, cell("code"),
        cell("constants"), cell("scene_bytes"), cell("pictures"),
        cell("instructions") / 1e6, cycles / 1e6, factor[$1], speed
}
table == "brief" && ($1 != "pico" || cell("cores") == 2) {
    printf "| %s | %s %s, %s | %.1f | %d | %.1f | %.1f |\n", label, cell("picture"),
        cell("format"), cell("tiles"), ram / 1024, flash / 1024 + 0.5,
        cell("instructions") / 1e6, speed
}
table == "cores" && $1 == "pico" {
    printf "| `%s` | %d | %d | %.1f | %.1f | %d | %s |\n", cell("scene"), cell("cores"),
        1000 / speed + 0.5, cycles / 1e6, ram / 1024, flash / 1024 + 0.5,
        long(cell("stack"))
}
