#!/bin/sh
# SPDX-License-Identifier: MIT
# The 820 meshes of Debian's sweethome3d-furniture, made by people with many programs: all
# are drawn, none is refused.  Missing things are reported, and counted here by kind.
. "$(dirname "$0")/../lib/script.sh"

furniture=/usr/share/sweethome3d/furniture
program=$(realpath "${1:-build/host/tidepool}")
drawer=$(realpath "${TP_BUILD:-build/host}/tests/host/furniture")
[ -d "$furniture" ] ||
    { skip "meshes of furniture" "sweethome3d-furniture"; exit 77; }
lacks unzip unzip "meshes of furniture" && exit 77

# In a folder so deep that every path is too long for a scene.
deep=$scratch/$(printf '%0200d' 0)/$(printf '%0200d' 0)
unpacked()
{
    for archive in "$furniture"/*.sh3f; do
        folder=$deep/$(basename "$archive" .sh3f)
        mkdir -p "$folder" && unzip -q "$archive" -d "$folder" || return 1
    done
    find "$deep" -iname '*.obj' | sort >"$scratch/meshes"
    [ "$(wc -l <"$scratch/meshes")" -ge 820 ]
}
check "820 meshes are unpacked" unpacked

# Counts the messages, without the files' names.
tally()
{
    sed -E 's/material .* is not/material X is not/; s/[0-9.]+ (m|faces?|texture)/N \1/
        s/scale [0-9.]+/scale N/; s/.*: ([^:]*(: boat.*)?; )/\1/
        s/boat.scale = [0-9.]+/boat.scale = N/' "$1" | sort | uniq -c | sort -rn |
        sed 's/^/    /'
}
drawn()
{
    tr '\n' '\0' <"$scratch/meshes" |
        xargs -0 -n 100 "$drawer" assets/scenes/minimal.ini 32x24 >"$scratch/drawn" \
            2>"$scratch/said"
    code=$?
    sed "/ drawn$/d; s,$deep/,," "$scratch/drawn"
    return $code
}
check "all of them are drawn at 32x24 and seen" drawn
tally "$scratch/said"

# Runs a few through the program: one of each archive.
rendered()
{
    for archive in "$furniture"/*.sh3f; do
        mesh=$(grep -F "/$(basename "$archive" .sh3f)/" "$scratch/meshes" | sed -n 20p)
        "$program" render minimal --size 32x24 --set boat.mesh="$mesh" \
            --out "$scratch/mesh-%d.png" || return 1
        [ -s "$scratch/mesh-0.png" ] || return 1
        rm "$scratch/mesh-0.png"
    done
}
check "one of each archive is rendered" rendered
mesh=$(grep /saloon_table.obj "$scratch/meshes")
refuse "one that lacks something is refused by --strict" \
    "$program" render minimal --size 32x24 --set boat.mesh="$mesh" --hash --strict
finish
