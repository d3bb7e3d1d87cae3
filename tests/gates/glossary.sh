#!/bin/sh
# SPDX-License-Identifier: MIT
# Each word of a public type or function is defined in src/GLOSSARY.md.  A plural counts
# as its singular.
. "$(dirname "$0")/../lib/script.sh"

glossary=src/GLOSSARY.md

# identifiers FOLDER: types and functions that the headers of FOLDER/tidepool declare.
# Macros and their lists are left out, and, as in headers.sh, names that a program's list
# is made of: stages, stores, conditions.
identifiers()
{
    rm -f "$scratch/names"
    for header in "$1"/tidepool/*.h; do
        echo "#include \"tidepool/${header##*/}\""
    done >"$scratch/all.c"
    gcc -std=c11 -I"$1" -fsyntax-only -aux-info "$scratch/functions" "$scratch/all.c" &&
        sed -n 's|.*tidepool/.* \(static\|extern\) [^(]*[ *]\(tp_[a-z0-9_]*\) (.*|\2|p' \
            "$scratch/functions" >"$scratch/names" &&
        cat "$1"/tidepool/*.h | awk '
            continued || /^[ \t]*#/ { continued = /\\$/; next }
            {
                line = $0
                while (line != "") {
                    at = index(line, within ? "*/" : "/*")
                    if (!within)
                        print at ? substr(line, 1, at - 1) : line
                    line = at ? substr(line, at + 2) : ""
                    within = at ? !within : within
                }
            }' | grep -o '\<tp_[a-z0-9_]*' >>"$scratch/names"
    grep -v '^tp_\(stage\|store\)_\|^tp_[a-z_]*_enabled$' "$scratch/names" | sort -u
}

# undefined GLOSSARY FOLDER: fails, and prints each word that the glossary lacks with an
# identifier that has it.
undefined()
{
    identifiers "$2" >"$scratch/identifiers"
    [ -s "$scratch/identifiers" ] || { echo "$2: no identifiers"; return 1; }
    sed -n 's/^- \*\*\([a-z0-9 -]*\)\*\*: .*/\1/p' "$1" >"$scratch/defined"
    awk '
        FNR == NR { defined[$0]; next }
        {
            n = split($0, word, "_")
            for (i = 2; i <= n; i++) {
                one = word[i]
                if (one in defined || one ~ /^(of|into|or|and)$/)
                    continue
                if (!sub(/s$/, "", one) || !(one in defined) \
                    && (!sub(/e$/, "", one) || !(one in defined)))
                    if (!seen[word[i]]++) {
                        printf "%s: no word of the glossary: %s\n", $0, word[i]
                        bad = 1
                    }
            }
        }
        END { exit bad }' "$scratch/defined" "$scratch/identifiers"
}
check "the glossary defines each word of public types and functions" \
    undefined $glossary include
enough() { wc -l "$scratch/identifiers"; [ "$(wc -l <"$scratch/identifiers")" -gt 100 ]; }
check "public types and functions are found" enough

# orderly GLOSSARY: each entry is one line, sorted within its section, and stands once.
orderly()
{
    awk '
        /^## / { last = ""; next }
        /^- / {
            if ($0 !~ /^- \*\*[a-z0-9 -]+\*\*: ./) {
                print FILENAME ":" FNR ": no entry: " $0
                bad = 1
                next
            }
            word = $0
            sub(/^- \*\*/, "", word)
            sub(/\*\*: .*/, "", word)
            if (last != "" && word "" <= last "") {
                print FILENAME ":" FNR ": not in order: " word
                bad = 1
            }
            last = word
            entries++
        }
        END { exit bad || !entries }' "$1"
}
check "the glossary is sorted, an entry a line" orderly $glossary

# put FILE LINE...: a file of these lines in the scratch folder.
mkdir -p "$scratch/made/tidepool"
put() { file=$scratch/$1; shift; printf '%s\n' "$@" >"$file"; }
made() { undefined "$scratch/words.md" "$scratch/made"; }

put words.md '## Nouns' '' '- **pool**: water.' '- **wave**: a crest.' '' '## Verbs' '' \
    '- **step**: goes on.'
put made/tidepool/a.h '/* A tp_comment of words. */' '#define TP_ZORB_LIST(X) X(zorb)' \
    '#define tp_macro(x) \' '    tp_other(x)' 'typedef struct tp_pool { int zorb; } tp_pool;' \
    'void tp_pool_step(tp_pool *pool, int zorb);' 'int tp_waves_of_pool(void);'
check  "glossary: passes known nouns" made
put made/tidepool/a.h 'typedef struct { int x; } tp_zorb;'
refuse "glossary: an unknown noun of a type" made
put made/tidepool/a.h 'struct tp_pool_zorb;'
refuse "glossary: of a struct's tag" made
put made/tidepool/a.h 'void tp_pool_zorb(int x);'
refuse "glossary: of a function" made
put made/tidepool/a.h '#define X(name) int tp_##name(void);' 'X(zorb)'
refuse "glossary: of a function that a macro declares" made
put made/tidepool/a.h 'static inline int tp_zorb(void) { return 1; }'
refuse "glossary: of an inline function" made
put made/tidepool/a.h '#define TP_POOL 1'
refuse "glossary: headers without any" made

put words.md '- **wave**: a crest.' '- **pool**: water.'
refuse "glossary: entries out of order" orderly "$scratch/words.md"
put words.md '- **pool**: water.' '- **pool**: more water.'
refuse "glossary: an entry that stands twice" orderly "$scratch/words.md"
put words.md '- **pool**' 'water.'
refuse "glossary: an entry without a definition" orderly "$scratch/words.md"
finish
