#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs the preview for 10000 frames under the sanitizers, with its panel, in a window of a
# private X server: nothing leaks.
#     leaks.sh PROGRAM
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/display.sh"
program_begin "$1"
sanitized=$root/build/san/tidepool
lacks Xvfb xvfb "the preview's leaks" && exit 0
[ -x "$sanitized" ] || { fail "$sanitized" "make test-all builds it"; exit 1; }
"$sanitized" view no-such-scene 2>&1 | grep -q 'built without the preview' &&
    { skip "the preview's leaks" "libsdl2-dev"; exit 0; }

begin_server 800x600
SDL_VIDEODRIVER=x11 SDL_AUDIODRIVER=dummy XDG_STATE_HOME=$work
export SDL_VIDEODRIVER SDL_AUDIODRIVER XDG_STATE_HOME

# The display's libraries keep memory until the end, and some are unloaded by then: only
# leaks requested by a function of the preview count.
timeout 200 "$sanitized" view minimal --size 64x48 --frames 10000 --stats >out 2>err </dev/null
code=$?
ours=$(awk '/ leak of / { n = 0; text = $0 }
    / in .* (ports|src|tests)\// || /imgui/ { n++; if (n == 1) print text ": " $0 }' err)
verdict "10000 pictures, nothing leaks" "$ours"
same "nothing else was found" "$(grep -c -e 'AddressSanitizer: [^0-9]' -e 'runtime error' \
    -e 'tidepool' err)" 0
verdict "a clean end, or with others' leaks" \
    "$([ $code -eq 0 ] || [ $code -eq 1 ] || echo "exit code $code")"
same "all of them were drawn, beside the panel" \
    "$(sed 's/.*"pictures": \([0-9]*\).*"has_panel": \([a-z]*\).*/\1 \2/' out)" "10000 true"
finish
