#!/bin/sh
# SPDX-License-Identifier: MIT
# Predicted against measured cost and error of sets of rungs, in views of a shipped scene at
# random: cameras, sizes, seas and light that no price was fitted to, those that
# tests/budgets/rung-judge.sh judges by default.  As rows of the sweep:
#
#   tests/charts/predicted.sh cost SCENE     instructions of four sets of a view's walk; the
#                                            emulated Cortex-M4 counts them
#   tests/charts/predicted.sh error SCENE    rms, of 255, of all sets of a view's walk
. "$(dirname "$0")/../lib/script.sh"

[ $# = 2 ] || { echo "usage: predicted.sh cost|error SCENE" >&2; exit 2; }
case $1 in
cost)
    tests/budgets/rung-prices.sh --scene "$2" sets 1 2001 >"$scratch/sets" || exit 1
    awk -v scene="$2" '{
        print "predicted,cost;" scene ";" $4 ",predicted," $NF
        print "predicted,cost;" scene ";" $4 ",m4," $6 }' "$scratch/sets" ;;
error)
    build/host/tests/budgets/rung_samples "assets/scenes/$2.ini" 1001 1 walk \
        >"$scratch/walk" || exit 1
    awk -v scene="$2" '$1 == "walk" && $2 > 0 {
        print "predicted,error;" scene ";" $2 ",predicted," $5
        print "predicted,error;" scene ";" $2 ",rms," $6 }' "$scratch/walk" ;;
esac
