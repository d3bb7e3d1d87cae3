#!/bin/sh
# SPDX-License-Identifier: MIT
# Lines sent to a live board: the answer to each line, and the board's picture after the
# change, which must equal the host's picture of the changed scene.
#
#   tests/boards/control.sh [PROGRAM]
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/board.sh"

program=${TP_PROGRAM:-${1:-build/host/tidepool}}
board_ready "control of a Cortex-M3"

answered()      { is "$(ask "$1")" "$2"; }
draws()         # [OPTION]...: the next picture is the host's at that tick
{
    state=$(ask state)
    is "$(crc_of "$state")" "$(host_crc "$(tick_of "$state")" "$@")"
}

# -- answers ---------------------------------------------------------------------------

check "pause" answered "pause" "ok pause"
check "get" answered "get wave0.length" "ok wave0.length = 4.2 m of 0.25..2000"
check "a number out of its range" answered "set wave0.amplitude 99" \
    "error wave0.amplitude = 99 is outside 0..16 m"
check "no number" answered "set wave0.amplitude high" \
    "error wave0.amplitude: expected a number, found high"
check "no such name" answered "set wave0.height 1" \
    "error no parameter is called wave0.height"
check "no such command" answered "hello" \
    "error expected set get list drop poke input pause go step restart state"
check "what was baked" answered "set grid.vertices 64" \
    "error grid.vertices is fixed when a scene is baked"
check "drop" answered "drop" "ok drop"
check "poke" answered "poke 0 -2" "ok poke"
rows=$("$program" params --only pool | grep -c '^pool\.')
check "list" answered "list pool." "ok $rows parameters"
refused()       { ask "$1" | grep "$2"; }
check "what the world has no room for" refused "set pool.cols 48" \
    "^error pool.cols = 48 cells needs [0-9]* bytes of the world, which has [0-9]*\$"
check "a wave more, which a fan has room for" answered "set wave2.amplitude 1" \
    "ok wave2.amplitude = 1 m"
check "what the program lacks" answered "set sky.kind day" \
    "error sky.kind: the program lacks sky_dome"
check "as it was" answered "set wave2.amplitude 0" "ok wave2.amplitude = 0 m"

# -- hostile lines -----------------------------------------------------------------------

long=$(printf '%0700d' 0)
check "a line too long" answered "$long" "error line longer than 160 bytes"
check "bytes that are no text" answered "$(printf 'set \377\001')" \
    "error line with byte 255, which is not text"
check "and the next line is read" answered "get wave0.amplitude" \
    "ok wave0.amplitude = 0.1 m of 0..16"
# More bytes than the port's ring buffer holds, while the board computes ticks and reads
# nothing.
ask "step 400" >/dev/null
before=$(answers)
{
    i=0
    while [ $((i += 1)) -le 100 ]; do
        printf 'get wave%d.length\r\n' $((i % 2))
    done
} >&3
burst()
{
    until_true said_more $((before + 99))
    is "$(answers)" $((before + 100))
}
check "100 lines while it is busy are answered, each once" burst

# -- pictures ----------------------------------------------------------------------------

restarted()     { answered "restart" "ok restart" && answered "step $1" "ok step $1"; }
check "it begins anew" restarted 25
check "as the host does" draws
check "a number that the picture alone depends on" answered "set light.elevation 60" \
    "ok light.elevation = 60 degrees"
check "at once" draws --set light.elevation=60
refuse "that is another picture" draws
check "the camera's place" answered "set camera.pitch=-30" \
    "ok camera.pitch = -30 degrees"
check "at once too" draws --set light.elevation=60 --set camera.pitch=-30
check "a wave" answered "set wave0.amplitude 0.25" "ok wave0.amplitude = 0.25 m"
check "and a colour" answered "set water.colour #808080" "ok water.colour = #808080"
check "from the beginning" restarted 60
check "as the host with the same numbers" draws --set light.elevation=60 \
    --set camera.pitch=-30 --set wave0.amplitude=0.25 --set water.colour=#808080
refuse "which differ from others" draws --set light.elevation=60 \
    --set camera.pitch=-30 --set wave0.amplitude=0.24 --set water.colour=#808080

# Each line needs a module that the scene as baked does not use.
changes="light.elevation=60 camera.pitch=-30 wave0.amplitude=0.25 water.colour=#808080"
switched()      # NAME=VALUE: in addition to all earlier changes
{
    changes="$changes $1"
    answered "set $1" "ok $(echo "$1" | sed 's/=/ = /')$2" && restarted 60 || return 1
    # shellcheck disable=SC2046,SC2086
    draws $(printf -- '--set %s ' $changes)
}
check "sharp crests" switched wave0.exponent=3
check "a paddle" switched pool.paddle=0.5 " m"
check "no glint" switched water.specular=0
check "and no mirror: diffuse light" switched water.reflection=0

goes_on()       { answered go "ok go" && until_true later; }
later()         { [ "$(tick_of "$(ask state)")" -gt 60 ]; }
check "it goes on by itself" goes_on
echo "deepest stack: ${state##*stack } bytes"
finish
