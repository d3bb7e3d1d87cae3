# SPDX-License-Identifier: MIT
# A feature is known only in its own folder.
#
#   awk -f tests/gates/features.awk include/tidepool/*.h src/*/*.[ch] src/*/*/*.[ch]
#
# Headers of src/features/NAME are included only by files of that folder, and names that
# begin with tp_FEATURE_ occur only there. Each file that declares a module is a feature,
# so the list of names follows the code. The list of modules, tidepool/modules.h, and
# features/all*.c name all features; public headers may declare a feature's functions.
BEGIN {
    # Prefixes of the modules; files are read twice, first for the prefixes.
    for (i = 1; i < ARGC; i++)
        if (ARGV[i] ~ /src\/features\/[a-z_]+\//) {
            folder = ARGV[i]
            sub(/^.*src\/features\//, "", folder)
            sub(/\/.*/, "", folder)
            while ((getline line < ARGV[i]) > 0)
                if (match(line, /tp_[a-z_]+_module = /)) {
                    name = substr(line, RSTART, RLENGTH - length("_module = "))
                    home[name "_"] = folder
                }
            close(ARGV[i])
        }
    for (name in home)
        found++
    if (!found) {
        print "no module in src/features"
        bad = 1
        exit
    }
}

FNR == 1 {
    here = ""
    if (FILENAME ~ /src\/features\/[a-z_]+\//) {
        here = FILENAME
        sub(/^.*src\/features\//, "", here)
        sub(/\/.*/, "", here)
    }
}

FILENAME ~ /src\/features\/all(_rows)?\.c$/ || FILENAME ~ /include\/tidepool\// { next }

/^[ \t]*#[ \t]*include[ \t]*"features\// {
    there = $0
    sub(/^[^"]*"features\//, "", there)
    sub(/\/.*/, "", there)
    if (there != here) {
        printf "%s:%d: features/%s is not its own: %s\n", FILENAME, FNR, there, $0
        bad = 1
    }
    next
}

{
    code = $0
    gsub(/\/\*[^*]*\*\//, "", code)
    for (name in home) {
        rest = code
        while (match(rest, "(^|[^a-z_])" name "[a-z_]+[(]?")) {
            word = substr(rest, RSTART, RLENGTH)
            if (home[name] != here && word ~ /[(]$/) {
                printf "%s:%d: %s belongs to features/%s\n", FILENAME, FNR, word, home[name]
                bad = 1
            }
            rest = substr(rest, RSTART + RLENGTH)
        }
    }
}

END { exit bad }
