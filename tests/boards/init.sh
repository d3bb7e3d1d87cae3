#!/bin/busybox sh
# SPDX-License-Identifier: MIT
# The first process of an emulated machine: mounts file systems, loads modules, runs the
# test's script of cases, and requests power-off. The output of the cases goes to the
# serial port, which tests/lib/board.sh reads.
/bin/busybox --install -s /bin
PATH=/bin; export PATH
mount -t devtmpfs none /dev
mount -t proc none /proc
mount -t sysfs none /sys
stty -echo </dev/console
for module in /modules/*.ko; do          # $module_words: from the kernel's command line
    [ ! -e "$module" ] || insmod "$module" $module_words || echo "FAILED - $module"
done

# ask WORDS: requests an action from outside the machine; returns when the action is done.
ask()
{
    echo "vm: $*"
    read -r _ </dev/console
}

# check NAME COMMAND...: one case; prints the command's output if the case fails.
check()
{
    name=$1; shift
    if "$@" >/tmp/output 2>&1; then
        echo "ok - $name"
    else
        sed 's/^/    /' /tmp/output
        echo "FAILED - $name"
    fi
}

# until_true COMMAND...: repeats for at most ten seconds.
until_true()
{
    for _ in $(seq 200); do
        "$@" && return 0
        usleep 50000
    done
    return 1
}

# show NAME PROGRAM...: the program holds its last frame until the screen has been dumped
# as $boot-NAME; then the program is ended.
show()
{
    shown=$1; shift
    setsid -c "$@" --hold --hash </dev/tty1 >/tmp/said 2>&1 &
    until_true grep -q "^frame" /tmp/said
    ask shot "$boot-$shown"
    kill $!
    wait $! 2>/dev/null
    check "it shows $shown, and ends by the signal that it was sent" \
        ended 143 $? "^frame"
}

# ended WANTED CODE WORDS: checks a program's exit code and output.
ended()
{
    cat /tmp/said
    echo "exit $2"
    [ "$2" = "$1" ] && grep -q -- "$3" /tmp/said
}

. /cases
echo "vm: end"
sleep 60
