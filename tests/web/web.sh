#!/bin/sh
# SPDX-License-Identifier: MIT
# The page: its module draws the program's frames, a browser shows the page, and input
# works.
#
#   tests/web/web.sh PROGRAM
#
# Without a browser the frames are still compared, with Node.js.
root=$PWD
page=$root/build/web
client=$root/build/tests/web            # the browser's driver is installed here
. "$(dirname "$0")/../lib/script.sh"
program_begin "$1"

for tool in clang=clang wasm-ld=lld node=nodejs; do
    lacks "${tool%=*}" "${tool#*=}" "the page" && { finish; exit; }
done

# An empty home folder for the browsers; npm reads the user's settings.
mkdir home
settled=${HOME:-$work/home}
export HOME="$work/home" XDG_CONFIG_HOME="$work/home" XDG_CACHE_HOME="$work/home"

(cd "$root" && build page) >out 2>err
same "make web builds the page" $? 0
bytes=$(gzip -9 -n -c "$root/build/wasm/tidepool.wasm" | wc -c)
lacks wasm-opt binaryen "the size of the module" ||
    same "the module with its scenes is below 258 KB, packed" \
        "$([ "$bytes" -lt 258000 ] && echo below)" below

# -- frames equal the program's --------------------------------------------------------

asked() {
    for scene in $(cd "$root" && make -s list-scenes); do
        echo "$scene 64x48 xrgb8888 0 30"
    done
    echo "three-swells 320x240 xrgb8888 0"
    for format in rgb565 p8 l8 i1; do
        echo "storm 104x60 $format 3"
    done
}
asked >asked
told() {
    while read -r scene size format frames; do
        for frame in $frames; do
            "$program" render "$scene" --size "$size" --format "$format" \
                --frames "$frame:$frame" --hash | sed "s/^/$scene $size $format /"
        done
    done <asked
}
told >wanted 2>err
node "$root/tests/web/frames.js" "$page" <asked >got 2>err
same "the module draws every scene's frames bit for bit" \
    "$(cmp wanted got 2>&1 | head -1) $(wc -l <got)" " $(wc -l <wanted)"

frame_with() { echo "tank 64x48 xrgb8888 $1 0 90" | node "$root/tests/web/frames.js" "$page"; }
calm=$(frame_with pool.splash_interval=0)
same "an old name of a parameter sets the same value" "$(frame_with pool.poke_every=0)" "$calm"
same "which is not the scene's" "$([ "$(frame_with '')" != "$calm" ]; echo $?)" 0

# -- the server ------------------------------------------------------------------------

: >served
(cd "$root" && exec node ports/web/serve.js build/web 8080) >served 2>err &
server=$!
at_end 'kill $server 2>/dev/null'
until_true grep -q http served
url=$(sed -n 's/ .*//p' served)
node -e '
const http = require("http"), port = new URL(process.argv[1]).port;
const get = (path, done) => http.get({ port, path }, answer => {
    answer.resume();
    done(answer.statusCode + " " + answer.headers["content-type"]);
});
get("/", a => get("/../../README.md", b => get("/%2e%2e%2fREADME.md", c =>
    get("/README.md", d => console.log([a, b, c, d].join("; "))))));' "$url" >out 2>err
same "make serve serves the page and nothing else" "$(cat out)" \
    "200 text/html; charset=utf-8; 404 text/plain; 404 text/plain; 404 text/plain"

# -- the page, in a browser ------------------------------------------------------------

if ! lacks chromium chromium "the page in a browser" &&
        ! lacks npm npm "the page in a browser"; then
    mkdir -p "$client"
    if ! cmp -s "$root/tests/web/package-lock.json" "$client/package-lock.json" \
            || [ ! -d "$client/node_modules/playwright-core" ]; then
        cp "$root/tests/web/package.json" "$root/tests/web/package-lock.json" \
            "$root/tests/web/.npmrc" "$client"
        (cd "$client" && HOME=$settled npm ci --no-audit --no-fund --ignore-scripts \
            --no-update-notifier --cache "$work/npm") >out 2>err
        same "the browser's driver is installed" $? 0
    fi
    timeout 240 node "$root/tests/web/page.mjs" "$client" "$page" "$program" "$url" \
        "$root/assets" >cases 2>err </dev/null
    code=$?
    cat cases
    passed=$((passed + $(grep -c '^ok - ' cases)))
    failed=$((failed + $(grep -c '^FAILED - ' cases)))
    same "the browser's test runs to its end" "$code" 0
fi
finish
