# SPDX-License-Identifier: MIT
# Words forbidden in the core: floating point, the heap, the C library, jumps, threads and
# locks. Comments and strings may contain them.
#
#   awk -f tests/gates/words.awk include/tidepool/*.h src/*/*
BEGIN {
    n = split("float double _Complex malloc calloc realloc free alloca printf sprintf " \
              "fopen FILE exit abort setjmp longjmp goto volatile errno " \
              "_Atomic _Thread_local", word, " ")
    for (i = 1; i <= n; i++)
        banned[word[i]]
}

FNR == 1 { within = 0 }

{
    line = $0
    gsub(/"([^"\\]|\\.)*"/, "\"\"", line)
    code = ""
    while (line != "") {
        if (within) {
            end = index(line, "*/")
            line = end ? substr(line, end + 2) : ""
            within = !end
        } else {
            start = index(line, "/*")
            code = code " " (start ? substr(line, 1, start - 1) : line)
            line = start ? substr(line, start + 2) : ""
            within = start > 0
        }
    }
    sub(/\/\/.*/, "", code)
    gsub(/[^A-Za-z0-9_]+/, " ", code)
    n = split(code, token, " ")
    for (i = 1; i <= n; i++)
        if (token[i] in banned || token[i] ~ /^(__atomic|__sync|atomic|pthread|mtx)_/) {
            printf "%s:%d: the core does without \"%s\"\n", FILENAME, FNR, token[i]
            bad = 1
        }
}

END { exit bad }
