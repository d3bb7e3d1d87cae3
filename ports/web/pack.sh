#!/bin/sh
# SPDX-License-Identifier: MIT
# Packs files as base64 tables into plain scripts; a page opened from a folder can read them.
#
#   ports/web/pack.sh module X.wasm >module.js      TIDEPOOL.module, gzip'd
#   ports/web/pack.sh files ASSETS >files.js        TIDEPOOL.files["textures/water.png"]
#
# PNGs are packed unchanged, text gzip'd.  No date is stored: equal files give equal scripts.
set -eu
usage() { echo "usage: ports/web/pack.sh module X.wasm | files ASSETS" >&2; exit 2; }
[ $# = 2 ] || usage
LC_ALL=C
export LC_ALL

packed() { gzip -9 -n -c "$1" | base64 -w0; }

case $1 in
module)
    printf "var TIDEPOOL = TIDEPOOL || {};\nTIDEPOOL.module = '%s';\n" "$(packed "$2")" ;;
files)
    cd "$2"
    printf 'var TIDEPOOL = TIDEPOOL || {};\nTIDEPOOL.files = {\n'
    for name in boats/*.obj boats/*.mtl; do
        printf "'%s': '%s',\n" "$name" "$(packed "$name")"
    done
    for name in boats/*.png textures/*.png skies/*.png; do
        printf "'%s': '%s',\n" "$name" "$(base64 -w0 "$name")"
    done
    printf '};\n' ;;
*)
    usage ;;
esac
