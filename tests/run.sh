#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs tests, TP_JOBS at a time, and adds up their results. The default is one more than
# the number of processors, since some tests wait for a screen or a machine.
#
#   tests/run.sh LOGS TEST...
#
# A test is a program or script that exits with 0 if it passed, or with 77 if it could not
# run. Scripts receive TP_PROGRAM as the program under test. A test prints a line for each
# case, cmocka's lines or for scripts
#     ok - NAME        FAILED - NAME        skipped: NAME (package PKG)
# The whole output goes to LOGS/TEST.log and is shown if the test fails. A skip is printed
# and counted, and fails nothing unless TP_STRICT is set. The last line of the run is "N
# passed, N failed[, N skipped]".
set -u
export TP_PROGRAM="${TP_PROGRAM:-build/host/tidepool}" TP_BUILD="${TP_BUILD:-build/host}"

run_one()       # LOGS TEST
{
    name=${2#./} name=${name#build/} name=${name%.sh}
    log=$1/$name.log
    mkdir -p "${log%/*}"
    begun=$(date +%s)
    case $2 in
    *.sh) timeout "${TP_TIMEOUT:-900}" "$2" "$TP_PROGRAM" >"$log" 2>&1 </dev/null ;;
    *)    timeout "${TP_TIMEOUT:-900}" "$2" >"$log" 2>&1 </dev/null ;;
    esac
    code=$?
    seconds=$(($(date +%s) - begun))
    times >"$log.times"         # of this process and of the test, the only child so far
    awk -v code=$code -v name="$name" -v seconds=$seconds -v result="$log.result" \
        -v times="$log.times" '
        function used(    line, part) {         # the test'"'"'s processor time, in seconds
            while ((getline line <times) > 0)
                split(line, part, /[ms ]+/)
            return part[1] * 60 + part[2] + part[3] * 60 + part[4]
        }
        /^\[       OK \]/ || /^ok /         { passed++ }
        /^\[  FAILED  \] [^0-9]/ && !($4 in seen) { seen[$4]; failed++ }
        /^FAIL(ED)? /                       { failed++ }
        /^skipped: /                        { skipped++; skip[skipped] = $0 }
        /^\[  SKIPPED \] [^0-9]/            { skipped++; skip[skipped] = "skipped: " $4 }
        END {
            if (code == 77 && !skipped)
                skip[skipped = 1] = "skipped: " name " (exit 77, no reason given)"
            if (code == 77 && !failed) code = 0
            if (code && !failed) failed = 1         # crashed, or hung and was ended
            if (!code && failed) code = 1           # reports a failure, but exits with 0
            line = sprintf("%-44s %4d passed %3ds %6.1fs used", name, passed, seconds,
                           used())
            if (failed) line = line sprintf("  %d FAILED (exit %d)", failed, code)
            print line
            for (i = 1; i <= skipped; i++) print skip[i]
            print passed + 0, failed + 0, skipped + 0 > result
            exit failed > 0
        }' "$log" || {
        grep -E -B 6 -A 2 'FAIL|ERROR|rror:|undefined|Assert' "$log" | head -n 40 |
            sed 's/^/    | /'
        echo "    | all of it: $log"
    }
}

if [ "$1" = -one ]; then
    output=$(run_one "$2" "$3")
    echo "$output"
    exit 0
fi

logs=$1; shift
rm -rf "$logs"; mkdir -p "$logs"
printf '%s\n' "$@" | xargs -P "${TP_JOBS:-$(($(nproc) + 1))}" -I{} "$0" -one "$logs" {}
find "$logs" -name '*.result' -exec cat {} + |
    awk -v tests=$# -v strict="${TP_STRICT:-}" '
    { passed += $1; failed += $2; skipped += $3; n++ }
    END {
        failed += tests - n
        line = passed + 0 " passed, " failed + 0 " failed"
        print skipped ? line ", " skipped " skipped" : line
        exit failed > 0 || (strict != "" && skipped > 0) || passed == 0
    }'
