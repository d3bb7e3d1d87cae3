#!/bin/busybox sh
# SPDX-License-Identifier: MIT
# The first process of an emulated machine: mounts what there is, loads the modules, reads
# the test's script of cases, and asks to be put out.  What the cases print goes to the
# serial port, which vm.sh listens to.
/bin/busybox --install -s /bin
PATH=/bin; export PATH
mount -t devtmpfs none /dev
mount -t proc none /proc
mount -t sysfs none /sys
stty -echo </dev/console
for module in /modules/*.ko; do          # $module_words: of the kernel's command line
    [ ! -e "$module" ] || insmod "$module" $module_words || echo "FAILED - $module"
done

# ask WORDS: what only the outside can do; returns when it was done.
ask()
{
    echo "vm: $*"
    read -r _ </dev/console
}

# check NAME COMMAND...: one case; what it prints is shown if it fails.
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

# until COMMAND...: tries for ten seconds.
until_true()
{
    for _ in $(seq 200); do
        "$@" && return 0
        usleep 50000
    done
    return 1
}

# show NAME PROGRAM...: it holds its last frame until the screen has been dumped as
# $boot-NAME; then it is asked to end.
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

# ended WANTED CODE WORDS: how a program ended, and what it said.
ended()
{
    cat /tmp/said
    echo "exit $2"
    [ "$2" = "$1" ] && grep -q -- "$3" /tmp/said
}

. /cases
echo "vm: end"
sleep 60
