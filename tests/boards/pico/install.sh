#!/bin/sh
# SPDX-License-Identifier: MIT
# Installs the emulator's package in a folder, unless it is there:
#
#   tests/boards/pico/install.sh FOLDER
here=$(dirname "$0") cache=$(mktemp -d) || exit 1
trap 'rm -rf "$cache"' EXIT
cmp -s "$here/package-lock.json" "$1/package-lock.json" &&
    [ -d "$1/node_modules/rp2040js" ] && exit
mkdir -p "$1"
cp "$here/package.json" "$here/package-lock.json" "$here/.npmrc" "$1"
npm ci --prefix "$1" --no-audit --no-fund --ignore-scripts --no-update-notifier \
    --cache "$cache"
