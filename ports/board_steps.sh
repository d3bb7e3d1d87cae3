#!/bin/sh
# SPDX-License-Identifier: MIT
# Draws each shipped scene exactly and at the step that the plan finds for a board, side by
# side on a page, with the figures of the step.
#
#   ports/board_steps.sh PROGRAM FOLDER [SCENE...]
#   ports/board_steps.sh --page FOLDER
#
# Writes FOLDER/SCENE-exact.png, FOLDER/SCENE-board.png, the table FOLDER/steps.csv of all
# named scenes, and the page FOLDER/README.md of the table; --page only the page.
set -eu
board=stm32f405 fps=10 tick=300 size=320x240

usage() { echo "usage: ports/board_steps.sh PROGRAM FOLDER [SCENE...]" >&2; exit 2; }
[ $# -ge 2 ] || usage
program=$1 folder=$2
shift 2

# -- pictures and the table ---------------------------------------------------------------

step()          # SCENE: its line of the table, and its pictures
{
    line=$("$program" plan "$1" --board $board --fps $fps --size $size --csv </dev/null |
        tail -n 1)
    exact=$("$program" plan "$1" --rung exact --size $size --csv </dev/null |
        awk -F, '$1 == "total"          { frame = $4 }
                 $1 == "tick" && $2 == "" { now = $4 }
                 $1 == "tick" && $2 != "" { world = $2; tick = now - $4 }
                 END { printf "%.2f,%s,%.2f", frame / 1e6, world, tick / 1e6 }')
    echo "$1,$exact,$line" >>"$folder/steps.csv"
    choices=$(echo "$line" | cut -d, -f4)
    "$program" render "$1" --size $size --frames $tick:$tick --rung exact \
        --out "$folder/$1-exact.png" </dev/null
    set -- "$1" $(echo "$choices" | sed 's/[^ ][^ ]*/--set &/g')
    scene=$1
    shift
    "$program" render "$scene" --size $size --frames $tick:$tick --rung exact "$@" \
        --out "$folder/$scene-board.png" </dev/null
}

if [ "$program" != --page ]; then
    [ $# -gt 0 ] || set -- $("$program" scenes | cut -d' ' -f1)
    mkdir -p "$folder"
    { printf scene,exact_m,world,world_m,
      echo board,fps,real_time,choices,frame_m,tick_m,ram,flash,added,db,speed_m; } \
        >"$folder/steps.csv"
    for scene; do
        echo "  $folder/$scene-board.png"
        step "$scene"
    done
fi

# -- the page -----------------------------------------------------------------------------

awk -F, -v board=$board -v fps=$fps -v tick=$tick '
    # Rows of one value together: "`fast`: haze, light; `nearest`: layers".
    function given_up(choices,    n, i, part, row, text, order, values, rows) {
        n = split(choices, part, " ")
        for (i = 1; i <= n; i++) {
            split(part[i], row, "=")
            sub(/^quality[.]/, "", row[1])
            if (!(row[2] in rows)) order[++values] = row[2]
            rows[row[2]] = rows[row[2]] (rows[row[2]] == "" ? "" : ", ") row[1]
        }
        for (i = 1; i <= values; i++)
            text = text (i > 1 ? "; " : "") (order[i] ~ /^[0-9]/ ? \
                rows[order[i]] " " order[i] : "`" order[i] "`: " rows[order[i]])
        return n ? text : "nothing"
    }
    function pictures(frame, tick_m) {
        return speed > 60 * tick_m ? (speed - 60 * tick_m) / frame : 0
    }
    NR == 1 {
        print "# Scenes on an " board ": exact, and what the board draws\n"
        print "Left the exact picture, right the step that `tidepool plan SCENE --board " \
            board " --fps " fps "`"
        print "finds: what the board draws " fps " times a second beside 60 ticks, or " \
            "its cheapest step of an"
        print "estimated error of 16 levels. Tick " tick ". Instructions are the plan\047s " \
            "estimates; dB are those of the pictures at ticks"
        print "60 and 300 against the exact ones."
        print "`ports/board_steps.sh build/host/tidepool assets/gallery/boards` makes " \
            "this again."
        next
    }
    {
        scene = $1; exact = $2; world = $3; world_m = $4; real_time = $7; choices = $8
        frame = $9; tick_m = $10; db = $14; speed = $15
        printf "\n## %s\n\n", scene
        printf "| exact: %s M instructions | %s: %s M, %s dB |\n", exact, board, frame, db
        print "|---|---|"
        printf "| ![%s, exact](%s-exact.png) ", scene, scene
        printf "| ![%s, as the board draws it](%s-board.png) |\n\n", scene, scene
        rate = pictures(frame, tick_m)
        if (rate > 0)
            printf "At most %.1f pictures a second%s.", rate, \
                real_time == "yes" ? ", in real time" : " beside ticks of " tick_m " M"
        else
            printf "No picture: 60 ticks of %s M take more than the board has.", tick_m
        if (real_time != "yes" && world != "")
            printf " With\n`%s`\na tick takes %s M: %.1f pictures a second.", world, \
                world_m, pictures(frame, world_m)
        printf "\nGives up: %s.\n", given_up(choices)
    }' "$folder/steps.csv" >"$folder/README.md"
