# SPDX-License-Identifier: MIT
# Functions shared by the program's tests; included by `.` from the project's root with
# the program's path as $1.  A test runs in a folder of its own.  Each case prints a line;
# the last line is "N passed, M failed", and the exit code agrees.
program=$(realpath "$1") || exit 2
vectors=$(realpath tests/vectors) || exit 2
work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
cd "$work" || exit 2
passed=0 failed=0
seconds=60                      # time limit of a run

# verdict NAME REASON: passed if the reason is empty.
verdict() {
    if [ -z "$2" ]; then
        passed=$((passed + 1))
        echo "ok - $1"
    else
        failed=$((failed + 1))
        echo "FAILED - $1: $2"
        sed 's/^/     | /' err | head -5
    fi
}

# run ARGUMENT...: runs the program, with streams to files out and err, exit code in
# $code.
run() {
    timeout "$seconds" "$program" "$@" >out 2>err </dev/null
    code=$?
}

# expect NAME CODE PATTERN ARGUMENT...: expects an exit code, and a line of stderr
# matching a basic regular expression; "" expects an empty stderr.
expect() {
    name=$1 want=$2 pattern=$3
    shift 3
    run "$@"
    judge "$name" "$want" "$pattern"
}

judge() {
    if [ "$code" -ne "$2" ]; then
        verdict "$1" "exit code $code, expected $2"
    elif [ -z "$3" ] && [ -s err ]; then
        verdict "$1" "unexpected message"
    elif [ -n "$3" ] && ! grep -q -e "$3" err; then
        verdict "$1" "no message like '$3'"
    else
        verdict "$1" ""
    fi
}

# same NAME TEXT TEXT: expects equal texts.
same() {
    if [ "$2" = "$3" ]; then verdict "$1" ""; else verdict "$1" "'$2' is not '$3'"; fi
}

# on_terminal NAME: true if script(1) can give a program a terminal.  Otherwise NAME is
# skipped, with the reason.
on_terminal() {
    if ! command -v script >/dev/null; then
        echo "skipped: $1 (package bsdutils)"
    elif ! script -qec true /dev/null >/dev/null 2>&1 </dev/null; then
        echo "skipped: $1 (no pseudo-terminal can be had: is /dev/pts mounted?)"
    else
        return 0
    fi
    return 1
}

# fits ARGUMENT...: expects an output that fits a screen.
fits() {
    run "$@"
    wide=$(awk 'length($0) > 80' out | wc -l)
    same "$* fits 24 lines of 80 columns" \
        "$code $([ "$(wc -l <out)" -le 24 ] && [ -s out ] && echo low) $wide" "0 low 0"
}

finish() {
    echo "$passed passed, $failed failed"
    [ "$failed" -eq 0 ]
}
