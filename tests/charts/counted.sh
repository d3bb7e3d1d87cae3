# SPDX-License-Identifier: MIT
# Runs a counting program of the charts and keeps its output and its counts; read by `.`.

# counted m4|x86 PROGRAM: writes $scratch/said and $scratch/counts, on an emulated
# Cortex-M4 by the board's compiler, or on this machine; both at -O2.
counted()
{
    case $1 in
    m4)
        emulate "build/cortex-m/$2.elf" "$scratch/said" "$scratch/counts" ;;
    x86)
        valgrind --tool=callgrind --callgrind-out-file="$scratch/dump" \
            --dump-before=count_section --collect-atstart=no --toggle-collect='run_*' \
            --compress-strings=no --compress-pos=no \
            "build/host/tests/charts/$2" >"$scratch/said" 2>"$scratch/words" &&
            awk -f tests/budgets/callgrind.awk "$scratch"/dump.* >"$scratch/counts" ;;
    *)
        echo "usage: $0 m4|x86 ..." >&2
        exit 2 ;;
    esac || { cat "$scratch"/words "$scratch"/said 2>/dev/null >&2; exit 1; }
}
