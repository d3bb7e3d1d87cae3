#!/bin/sh
# SPDX-License-Identifier: MIT
# Errors of whole frames as rows of the sweep, from the tables that tests/accuracy/errors.sh
# writes: mean, least and largest over the ticks, and other cameras at the last tick.
here=$(dirname "$0")/../accuracy

awk -F, '
    FNR == 1 { next }
    FILENAME ~ /twinkle/ { add($1 ";" $3 ";twinkle", $5); next }
    { add($1 ";" $3 ";" ($4 == "own" ? "rms" : $4), $5) }
    $4 == "own" { add($1 ";" $3 ";ssim", $7) }
    END {
        for (name in n) {
            print_row(name, "mean", sprintf("%.4g", sum[name] / n[name]))
            print_row(name, "least", least[name])
            print_row(name, "most", most[name])
        }
    }
    function add(name, value) {
        if (!(name in n) || value < least[name]) least[name] = value
        if (!(name in n) || value > most[name]) most[name] = value
        sum[name] += value
        n[name]++
    }
    function print_row(name, column, value) {
        print "accuracy," name "," column "," value
    }' "$here/errors.csv" "$here/twinkle.csv" | sort
