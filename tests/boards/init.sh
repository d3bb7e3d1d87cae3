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
for module in /modules/*.ko; do
    [ ! -e "$module" ] || insmod "$module" || echo "FAILED - loading $module"
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

. /cases
echo "vm: end"
sleep 60
