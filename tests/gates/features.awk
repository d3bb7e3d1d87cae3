# SPDX-License-Identifier: MIT
# A feature is known only in its own folder.
#
#   awk -f tests/gates/features.awk include/tidepool/*.h src/*/*.[ch] src/*/*/*.[ch]
#
# Headers of src/features/NAME are included only by files of that folder, and functions that
# the folder declares or defines, inline functions included, are called only there. The list
# of modules, tidepool/modules.h, and features/all*.c name all features; public headers may
# declare a feature's functions.
BEGIN {
    # Functions of each folder; files are read twice, first for the functions.
    for (i = 1; i < ARGC; i++)
        if (ARGV[i] ~ /src\/features\/[a-z_]+\//) {
            folder = ARGV[i]
            sub(/^.*src\/features\//, "", folder)
            sub(/\/.*/, "", folder)
            while ((getline line < ARGV[i]) > 0) {
                if (line ~ /_module = /)
                    found++
                if (line ~ /^[A-Za-z]/ && match(line, /tp_[a-z0-9_]+\(/))
                    home[substr(line, RSTART, RLENGTH)] = folder
            }
            close(ARGV[i])
        }
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
    while (match(code, /tp_[a-z0-9_]+\(/)) {
        word = substr(code, RSTART, RLENGTH)
        if (word in home && home[word] != here) {
            printf "%s:%d: %s) belongs to features/%s\n", FILENAME, FNR, word, home[word]
            bad = 1
        }
        code = substr(code, RSTART + RLENGTH)
    }
}

END { exit bad }
