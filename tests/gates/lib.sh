# SPDX-License-Identifier: MIT
# What the gates share; read by `.`, from the project's root.

failures=0

# check NAME COMMAND...: one case; what the command prints is shown if it fails.
check()
{
    name=$1; shift
    if "$@" >"$scratch/output" 2>&1; then
        echo "ok - $name"
    else
        sed 's/^/    /' "$scratch/output"
        echo "FAILED - $name"
        failures=$((failures + 1))
    fi
}

# refuse NAME COMMAND...: a case that holds when the command finds something wrong.
refuse()
{
    name=$1; shift
    if "$@" >"$scratch/output" 2>&1; then
        echo "FAILED - $name: nothing was found"
        failures=$((failures + 1))
    else
        echo "ok - $name"
    fi
}

# lacks TOOL PACKAGE NAME: true, and says so, when the tool is not there.
lacks()
{
    ! command -v "$1" >/dev/null && echo "skipped: $3 (package $2)"
}

# A build of its own, outside of the make that may have called us.
build()         # [VARIABLE=VALUE]... GOAL...
{
    env -u MAKEFLAGS -u MAKELEVEL -u MFLAGS make -j2 --no-print-directory "$@"
}

# alone COMMAND...: of those that build for other processors one at a time, since several
# tests use what they make.
alone()
{
    mkdir -p build/cross && (flock 9 && "$@") 9<build/cross
}

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
gates=tests/gates

core_files()  { find include src -name '*.[ch]' -o -name '*.inc' | sort; }
port_files()  { find ports -name '*.[ch]' | sort; }
every_file()
{
    find . \( -name .git -o -path ./build -o -path ./out \) -prune -o -type f \
        \( -name '*.[ch]' -o -name '*.inc' -o -name '*.sh' -o -name '*.awk' \
           -o -name '*.cpp' -o -name '*.S' -o -name '*.mk' -o -name '*.ld' -o -name Makefile \
           -o -path './.ci/run' \) \
        -print | sort
}

# Gates on an archive, by the tools of a target: "" is this machine, or "arm-none-eabi-".
symbols()     { "$1nm" -A "$2" | awk -f $gates/symbols.awk; }
no_state()    { "$1size" -A "$2" | awk -f $gates/state.awk; }
no_deeper()                     # BYTES FILE.ci...
{
    bytes=$1; shift
    awk -v limit="$bytes" -v pointers=$gates/pointers.txt -f $gates/stack.awk "$@"
}
no_floats()   { objdump -d --no-show-raw-insn "$1" | awk -f $gates/floats.awk; }
