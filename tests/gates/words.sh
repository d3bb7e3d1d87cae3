#!/bin/sh
# SPDX-License-Identifier: MIT
# Plain words and clear folders, each rule with examples that it must refuse: comments and
# names of functions (plain.awk), a README in each folder, no basename twice in the core.
. "$(dirname "$0")/../lib/script.sh"

# Names that two files of the core have; a name leaves the list when a file is renamed.
twice=recip_table.inc

# put FILE LINE...: a file of these lines in the scratch folder.
put()
{
    mkdir -p "$(dirname "$scratch/$1")"
    file=$scratch/$1; shift
    printf '%s\n' "$@" >"$file"
}

# -- comments and names of functions: include, src and ports for now ----------------------

plain_files()
{
    find include src ports -type f \( -name '*.[chS]' -o -name '*.inc' -o -name '*.cpp' \
        -o -name '*.ld' -o -name '*.css' -o -name '*.js' -o -name '*.sh' -o -name '*.awk' \
        -o -name '*.mk' \) | sort
}
plain() { awk -f $gates/plain.awk "$@"; }
check "comments and names of functions are plain" plain $(plain_files)

put good.c '/* Draws what is seen. */' 'const char *s = "/* Of */"; // Sum of all' \
    '/*' ' * Returns the height.' ' * Of no use elsewhere. */' 'int tp_height_at_rest(void);'
put good.sh '#!/bin/sh' '# Builds it.' '# What follows is one comment.' 'x=1  # a count'
check  "plain: passes comments and names" plain "$scratch/good.c" "$scratch/good.sh"
for word in Of What Whether How Which Where That Whose Who; do
    put bad.c 'int x;' "int y;  /* $word it counts. */"
    refuse "plain: a comment that opens with $word" plain "$scratch/bad.c"
done
put bad.c '/*' ' * What it draws. */'
refuse "plain: on the second line of a comment" plain "$scratch/bad.c"
put bad.c 'int a; // Fine' '' 'int b; // How it goes'
refuse "plain: behind //" plain "$scratch/bad.c"
put bad.js "const a = '//';" '// Whether it is on.'
refuse "plain: in JavaScript" plain "$scratch/bad.js"
for name in bad.sh bad.awk bad.mk; do
    put $name '# SPDX-License-Identifier: MIT' '# What it builds.'
    refuse "plain: in $name" plain "$scratch/$name"
done
put bad.sh 'build()         # Of a folder'
refuse "plain: behind a line of shell" plain "$scratch/bad.sh"
for name in tp_height_of tp_pool_at draw_into is_inside; do
    put bad.c "static int $name(int x)" '{' '}'
    refuse "plain: a function $name" plain "$scratch/bad.c"
done

# -- a README in each folder --------------------------------------------------------------

# with_readmes FOLDER: reads names of files below FOLDER; each folder has a README.md.
with_readmes()
{
    awk -F/ '{ path = $1; for (i = 2; i <= NF; i++) { print path; path = path "/" $i } }' |
        sort -u | {
        bad=0
        while read -r folder; do
            [ -f "$1/$folder/README.md" ] || { echo "$folder: no README.md"; bad=1; }
        done
        exit $bad
    }
}
tracked()       # without git, whatever lies there
{
    git ls-files src ports tests assets 2>/dev/null | grep . ||
        find src ports tests assets -type f
}
described() { tracked | with_readmes .; }
check "each folder of src, ports, tests and assets has a README" described

put tree/a/README.md 'All of it.'
put tree/a/b/README.md 'A part.'
tree() { printf '%s\n' "$@" | with_readmes "$scratch/tree"; }
check  "folders: passes those with a README" tree a/x.c a/b/y.c
refuse "folders: one without" tree a/x.c a/c/z.c
refuse "folders: one above a folder with a README" tree d/e/x.c

# -- names of files in the core -----------------------------------------------------------

# once "NAME...": reads names of files; those in the list are there twice, no others.
once()
{
    sed 's,.*/,,' | grep '\.\(c\|h\|inc\)$' | sort | uniq -d >"$scratch/double"
    printf '%s\n' $1 | sort | diff - "$scratch/double"
}
unique() { find src -type f | once "$twice"; }
check "no name of a file stands twice in the core, the list of exceptions aside" unique

names() { list=$1; shift; printf '%s\n' "$@" | once "$list"; }
check  "names: passes one of the list" names "b.c" src/x/a.c src/x/b.c src/y/b.c
refuse "names: one that is twice" names "b.c" src/x/a.c src/y/a.c src/x/b.c src/y/b.c
refuse "names: one of the list that is there once" names "b.c" src/x/a.c src/x/b.c
finish
