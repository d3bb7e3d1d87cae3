#!/bin/sh
# SPDX-License-Identifier: MIT
# The preview for 10000 pictures under the sanitizers, in a window of an X server of its
# own, with its panel: nothing leaks, and twice as many pictures take no more memory but
# what rewinding keeps.
#     leaks.sh PROGRAM
. tests/host/lib.sh
sanitized=$OLDPWD/build/san/tidepool
command -v Xvfb >/dev/null || { echo "skipped: the preview's leaks (package xvfb)"; exit 0; }
[ -x "$sanitized" ] || { echo "FAILED - $sanitized: make host-tests builds it"; exit 1; }

exec 7>number
Xvfb -displayfd 7 -screen 0 800x600x24 -nolisten tcp -noreset >/dev/null 2>&1 &
server=$!
trap 'kill $server; rm -rf "$work"' EXIT
for _ in $(seq 100); do [ -s number ] && break; sleep 0.1; done
DISPLAY=:$(cat number) SDL_VIDEODRIVER=x11 SDL_AUDIODRIVER=dummy XDG_STATE_HOME=$work
export DISPLAY SDL_VIDEODRIVER SDL_AUDIODRIVER XDG_STATE_HOME

# What the display's own libraries keep for ever is not the preview's.
cat >libraries <<'END'
leak:libX11
leak:libxcb
leak:libSDL2
leak:libdbus
leak:libfontconfig
leak:libGL
leak:swrast
END
export LSAN_OPTIONS="suppressions=$work/libraries:print_suppressions=0"

# pictures N OPTION...: so many, as fast as they come.
pictures() {
    count=$1
    shift
    timeout 300 "$sanitized" view tank --size 64x48 --frames "$count" --stats "$@" \
        >out 2>err </dev/null
    code=$?
}
peak() { sed 's/.*"peak_kb": \([0-9]*\).*/\1/' out; }

pictures 5000
same "5000 pictures, and a clean end" "$code $(cat err)" "0 "
half=$(peak)
pictures 10000
same "10000 pictures, nothing leaks" "$code $(cat err)" "0 "
same "all of them were drawn, beside the panel" \
    "$(sed 's/.*"pictures": \([0-9]*\).*"panel": \([a-z]*\).*/\1 \2/' out)" "10000 true"
grown=$(($(peak) - half))
verdict "5000 more take less than 16 MB, for rewinding" \
    "$([ "$grown" -lt 16384 ] || echo "$grown KB more")"
finish
