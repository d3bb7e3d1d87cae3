#!/bin/sh
# SPDX-License-Identifier: MIT
# Gates on the sources.
. "$(dirname "$0")/../lib/script.sh"

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

check "includes point down" awk -f $gates/layers.awk $(core_files) $(port_files)
check "a feature is known in its folder alone" \
    awk -f $gates/features.awk $(core_files | grep '\.[ch]$')
check "the core keeps to its words" awk -f $gates/words.awk $(core_files)
check "every file has its licence line, and no line is too long" \
    awk -f $gates/text.awk $(every_file)

contracts() { awk "$@" -f $gates/asserts.awk $(core_files | grep '^src/'); }
check "asserts have no effect: $(contracts | sed -n 's/^core *//p')" contracts
check "5 to 10 of them in a thousand lines" contracts -v least=5 -v most=10

listed()        # src/core.mk's list equals the folder's content
{
    build -s list-core | tr ' ' '\n' | sort >"$scratch/listed"
    find src -name '*.c' | sort | diff "$scratch/listed" -
}
check "the build lists every file of the core" listed
finish
