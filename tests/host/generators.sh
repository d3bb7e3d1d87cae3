#!/bin/sh
# SPDX-License-Identifier: MIT
# The boats and pictures in assets/ equal the output of their generators: text byte by
# byte, pictures pixel by pixel (another zlib may compress differently).  Skies take longest:
# they are made with TP_SOAK set.
. "$(dirname "$0")/../lib/script.sh"

generated=$scratch/generated
mkdir -p "$generated/boats" "$generated/textures" "$generated/skies"

same()          # FOLDER/FILE
{
    cmp "assets/$1" "$generated/$1" && return
    case $1 in
    *.png) build/host/tests/host/same_pixels "assets/$1" "$generated/$1" ;;
    *)     return 1 ;;
    esac
}

check "the generators build" build build/host/longship build/host/textures \
    build/host/tests/host/same_pixels
check "the longship's generator runs" build/host/longship "$generated/boats"
check "the textures' generator runs" build/host/textures "$generated/textures" \
    ${TP_SOAK:+"$generated/skies"}
for file in "$generated"/*/*; do
    name=${file#"$generated/"}
    check "$name is as generated" same "$name"
done
made=$(find "$generated" -type f | wc -l)
check "every kind of file was made" test "$made" -ge 15
finish
