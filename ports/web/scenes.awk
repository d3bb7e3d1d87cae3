# SPDX-License-Identifier: MIT
# Writes scenes as C strings, without comments and blanks:  awk -f scenes.awk *.ini >x.c
# Removes "../" from file names, since the page has all folders side by side.
function quoted(s) { gsub(/\\/, "\\\\", s); gsub(/"/, "\\\"", s); return "\"" s "\\n\"" }
BEGIN {
    print "/* SPDX-License-Identifier: MIT */"
    print "#include \"web.h\""
    print "const char *const web_scenes[] = {"
}
{ gsub(/^[ \t]+|[ \t\r]+$/, "") }
FNR == 1 {
    name = FILENAME
    sub(/.*\//, "", name)
    sub(/\.ini$/, "", name)
    if (count++) print ","
    print quoted(name)
}
/^$/ || /^[#;]/ { next }
{ sub(/[ \t]*=[ \t]*/, "="); sub(/=\.\.\//, "="); print quoted($0) }
END { print "};\nconst uint32_t web_scene_count = " count ";" }
