#!/bin/sh
# SPDX-License-Identifier: MIT
# The manual pages and the shells' completions: complete, well formed, and installed at
# the right places by make install.
#     manual.sh PROGRAM
root=$(pwd)
. "$(dirname "$0")/../lib/script.sh"
program_begin "$1"
HOME=$work XDG_CONFIG_HOME=$work/config
export HOME XDG_CONFIG_HOME

commands=$("$program" --help | sed -n 's/^  \([a-z]*\) .*  .*/\1/p')
same "the first command" "${commands%%[!a-z]*}" view
options_of()    # COMMAND: prints the options of its help, one per line
{
    "$program" "$1" --help 2>/dev/null | awk '
        /^  -/ { print $1 }
        $1 == "also" { also = 1; $1 = "" }
        NF == 0 { also = 0 }
        also { for (i = 1; i <= NF && $i != "see"; i++) if ($i ~ /^-/) print $i }' |
        tr -d ,: | sort -u
}
[ -n "$(options_of view)" ] || commands=$(echo "$commands" | grep -v view)  # no preview
parameters=$("$program" params | sed -n 's/^\([a-z0-9]*\.[a-z0-9_]*\) .*/\1/p')

# -- pages --------------------------------------------------------------------------

expect "the manual page" 0 "" manual
cp out tidepool.1
expect "the page of a scene" 0 "" manual --scene
cp out tidepool-scene.5
same "the program's page is long" "$([ "$(wc -l <tidepool.1)" -gt 300 ] && echo yes)" yes
expect "a manual of something" 2 "too many names" manual pond
if command -v mandoc >/dev/null; then
    verdict "mandoc has nothing to say of them" \
        "$(mandoc -T lint -W all tidepool.1 tidepool-scene.5 2>&1 | head -3)"
else
    skip "the manual's form" "mandoc"
fi
# tagged PAGE: prints the bold names at the start of a paragraph, one per line, unescaped.
tagged() { sed -n 's/^\\fB\([^ ]*\)\\fR.*/\1/p' "$1" | sed 's/\\-/-/g'; }

# Without the options common to all commands, which have a section of their own.
part_of()       # COMMAND
{
    sed -n "/^\.SS $1\$/,/^\.S[SH] /p" tidepool.1
    sed -n '/^\.SH OPTIONS OF EVERY COMMAND/,/^\.SH KEYS/p' tidepool.1
}
for command in $commands; do
    part_of "$command" >part
    tagged part | sort -u >tags
    options_of "$command" >wanted
    verdict "the page knows the options of $command" "$(comm -13 tags wanted | tr '\n' ' ')"
done
# For numbered groups with a common text, N stands for the numbers.
tagged tidepool-scene.5 | sort -u >tags
ranges=$(sed -n 's/^\.SS \([a-z]*\)\([0-9]*\) to [a-z]*\([0-9]*\)$/\1 \2 \3/p' \
    tidepool-scene.5)
same "waves are told once" "$(echo "$ranges" | grep wave)" "wave 0 15"
echo "$ranges" | while read -r name low high; do
    for n in $(seq "$low" "$high"); do
        sed -n "s/^${name}N\./$name$n./p" tags
    done
done | sort - tags >told
echo "$parameters" | sort >wanted
same "there are parameters" "$([ "$(wc -l <wanted)" -gt 300 ] && echo yes)" yes
verdict "the page knows every parameter" "$(comm -13 told wanted | head -3 | tr '\n' ' ')"
verdict "and no other" "$(comm -23 told wanted | grep -v -e 'N\.' -e tidepool | head -3)"
for key in F1 Space Ctrl+Z 'left drag' Escape; do
    same "the page knows $key" \
        "$(grep -c "^.fB${key}[ \\]" tidepool.1 | sed 's/[1-9][0-9]*/yes/')" yes
done
# A line that begins with a dot must be a macro, a backslash one of the known escapes, and
# a hyphen a minus sign.
for page in tidepool.1 tidepool-scene.5; do
    verdict "$page: nothing but its own macros" "$(grep '^[.'\'']' $page |
        grep -v -e '^\.\(TH\|SH\|SS\|TP\|PP\|br\|EX\|EE\)\( \|$\)' -e '^\.\\"' | head -3)"
    verdict "$page: nothing is left to be escaped" "$(grep -v '^\.' $page |
        sed 's/\\\([-&e]\|f[BIR]\|(aq\|(ga\|(ha\|(ti\)//g' | grep -e '[-\\^`~'\'']' | head -3)"
done

# -- bash -----------------------------------------------------------------------------

expect "completion of no shell" 2 "SHELL is missing" completion
expect "of an unknown shell" 2 "expected bash, zsh or fish" completion csh
expect "completion of bash" 0 "" completion bash
cp out tidepool.bash
cat >drive.bash <<'EOF'
source ./tidepool.bash
while IFS= read -r text; do         # a word per blank, as readline splits them
    IFS=' ' read -r -a COMP_WORDS <<<"$text"
    [[ $text != *' ' ]] || COMP_WORDS+=('')
    COMP_CWORD=$((${#COMP_WORDS[@]} - 1)) COMPREPLY=()
    function=$(complete -p tidepool)
    function=${function#complete -F } function=${function% tidepool}
    "$function" tidepool "${COMP_WORDS[-1]}" "${COMP_WORDS[-2]}"
    echo "${COMPREPLY[*]}"
done
EOF
if command -v bash >/dev/null; then
    completes()     # LINE WORDS
    {
        same "bash: $1" "$(printf '%s\n' "$1" | bash --norc drive.bash 2>&1)" "$2"
    }
    touch "$work/own.ini"
    completes 'tidepool ren' render
    completes 'tidepool --v' --version
    completes 'tidepool render three' three-swells
    completes 'tidepool render ./own' ./own.ini
    completes 'tidepool render --fo' --format
    completes 'tidepool render pond --format rgb' 'rgb565 rgb565be'
    completes 'tidepool render --format = i' i1
    completes 'tidepool plan pond --visibility r' rows
    completes 'tidepool view --threads ' ''
    completes 'tidepool bake pond -o own' own.ini
    completes 'tidepool params --only tan' tank.
    completes 'tidepool bench --work ' 'plain full smooth'
    completes 'tidepool show pond --on f' fb
    completes 'tidepool completion ' 'bash zsh fish'
    completes 'tidepool help comp' completion
    completes 'tidepool render pond --set boa' boat.
    completes 'tidepool render pond --set water.filt' water.filter=
    completes 'tidepool render pond --set water.filter = ' 'nearest linear'
    completes 'tidepool render pond --set = water.filter = l' linear
    completes 'tidepool render pond --set boat.mesh = own' own.ini
    completes 'tidepool render pond --set wave0.length = 1' ''
    completes 'tidepool render pond --hash --st' '--step --strip --stream --strict --stats'
    completes 'tidepool sail --s' ''
    sed -i '1iCOMP_WORDBREAKS=${COMP_WORDBREAKS//=}' drive.bash
    completes 'tidepool render --format=i' --format=i1
    completes 'tidepool render --set=water.filter=l' --set=water.filter=linear
    for command in $commands; do
        echo "tidepool $command -" | bash --norc drive.bash | tr ' ' '\n' | sort >offered
        options_of "$command" >wanted
        verdict "bash: the options of $command" \
            "$(diff offered wanted | grep '^[<>]' | tr '\n' ' ')"
    done
    echo "$parameters" | sed 's/\..*/./' | uniq |
        sed 's/^/tidepool render pond --set /' | bash --norc drive.bash | tr ' ' '\n' |
        sed 's/=$//' >offered
    echo "$parameters" >wanted
    verdict "bash: every parameter" "$(diff offered wanted | head -3)"
else
    skip "completion driven in bash" "bash"
fi

# -- zsh and fish, if installed ---------------------------------------------------------

for shell in zsh fish; do
    expect "completion of $shell" 0 "" completion $shell
    cp out tidepool.$shell
    for command in $commands; do
        options_of "$command"
    done | sed 's/^-*//' | sort -u | while read -r name; do
        grep -q -e "'-*\**-${name}[=[]" -e "'\*--${name}[=[]" -e " -[ls] $name " \
            tidepool.$shell || echo "$name"
    done >lost
    verdict "$shell: every option" "$(tr '\n' ' ' <lost)"
    echo "$parameters" | while read -r name; do
        grep -q -e "[ ']$name[ ']" -e " $name\$" tidepool.$shell || echo "$name"
    done >lost
    verdict "$shell: every parameter" "$(head -3 lost | tr '\n' ' ')"
    ! command -v $shell >/dev/null ||
        verdict "$shell reads it" "$($shell -n tidepool.$shell 2>&1)"
done
if command -v fish >/dev/null; then
    fishes()        # LINE WORDS
    {
        same "fish: $1" "$(fish --no-config -c "source tidepool.fish; complete -C '$1'" |
            cut -f1 | sort | tr '\n' ' ')" "$2"
    }
    fishes 'tidepool ren' 'render '
    fishes 'tidepool render three' 'three-swells '
    fishes 'tidepool plan pond --format rgb' 'rgb565 rgb565be '
    fishes 'tidepool render pond --set water.filter=' \
        'water.filter=linear water.filter=nearest '
fi

# -- installed files --------------------------------------------------------------------

if make -C "$root" --no-print-directory install DESTDIR="$work/to" PREFIX=/usr >log 2>&1
then
    share=$work/to/usr/share
    for pair in tidepool.1=man/man1/tidepool.1 \
            tidepool-scene.5=man/man5/tidepool-scene.5 \
            tidepool.bash=bash-completion/completions/tidepool \
            tidepool.zsh=zsh/site-functions/_tidepool \
            tidepool.fish=fish/vendor_completions.d/tidepool.fish; do
        verdict "installed: ${pair#*=}" "$(cmp "${pair%=*}" "$share/${pair#*=}" 2>&1)"
    done
else
    verdict "make install" "$(tail -3 log)"
fi

finish
