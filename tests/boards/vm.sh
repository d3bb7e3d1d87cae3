# SPDX-License-Identifier: MIT
# Emulated machines with Debian's own kernel; read by `.` after tests/gates/lib.sh.
#
# A test builds a boot's only file system from busybox, init.sh, the project's programs
# and a script of cases, and boots it. The cases print lines on the serial port; lines
# that begin with "vm: " request an action from outside the machine:
#
#     vm: shot NAME       dump the present screen to $vm_work/NAME.ppm
#     vm: key KEYS        send a key, by the monitor's names: ctrl-c, alt-f2
#     vm: end             all cases were run; power off
#
# Each request is answered with a line, so neither side waits for a fixed time. Lines "ok
# - ..." and "FAILED - ..." are the results of the cases: vm_results takes them over.
#
# apt downloads the kernels from Debian into build/vm/ARCH, with package lists of their
# own: root rights, architecture and state of this machine do not matter. Of a package of
# 400 MB only the parts for screens are unpacked.

PATH=$PATH:/usr/sbin:/sbin       # depmod, for users too
TP_BUILD=${TP_BUILD:-build/host}
vm_folder=build/vm
vm_work=$scratch/vm
mkdir -p "$vm_work"

# vm_lacks NAME: true, with a message, if a tool is missing or the kernels are not
# available.
vm_lacks()      # NAME ARCH...
(
    name=$1; shift
    lacks apt-get apt "$name" || lacks dpkg-deb dpkg "$name" || lacks cpio cpio "$name" ||
        lacks kmod kmod "$name" || lacks flock util-linux "$name" && return 0
    for arch; do
        case $arch in
        amd64) lacks qemu-system-x86_64 qemu-system-x86 "$name" && return 0 ;;
        arm64) lacks qemu-system-aarch64 qemu-system-arm "$name" &&  return 0
               lacks aarch64-linux-gnu-gcc gcc-aarch64-linux-gnu "$name" && return 0 ;;
        esac
        vm_kernel "$arch" >"$scratch/apt" 2>&1 && continue
        tail -n 3 "$scratch/apt"
        echo "skipped: $name (package linux-image-$arch)"
        return 0
    done
    return 1
)

# Needed parts of a kernel's package: the kernel, and modules for screens.
vm_paths()
{
    cat <<'EOF'
./boot/vmlinuz-*
./lib/modules/*/modules.*
./lib/modules/*/kernel/drivers/gpu/drm/*.ko
./lib/modules/*/kernel/drivers/virtio/*
./lib/modules/*/kernel/drivers/video/fbdev/*.ko
EOF
}

# vm_kernel ARCH: downloads the kernel, its modules and busybox to build/vm/ARCH unless
# present. Locked, since several tests need the same files.
vm_kernel()
{
    mkdir -p "$vm_folder" && (
        flock 9
        [ -e "$vm_folder/$1/modules" ] || vm_fetch "$1" "$(pwd)/$vm_folder/$1"
    ) 9<"$vm_folder"
}

vm_fetch()      # ARCH FOLDER
(
    arch=$1 to=$2
    rm -rf "$to" && mkdir -p "$to/lists/partial" && cd "$to" || return 1
    set -- -o "APT::Architecture=$arch" -o "APT::Architectures=$arch" \
        -o "Dir::State::Lists=$to/lists" -o Dir::Cache::pkgcache= \
        -o Dir::Cache::srcpkgcache= -o APT::Sandbox::User=root \
        -o Acquire::Retries=2 -o Acquire::http::Timeout=30
    timeout 300 apt-get "$@" -qq update &&
        image=$(apt-cache "$@" depends "linux-image-$arch" |
            awk '$1 == "Depends:" && /linux-image-/ { print $2; exit }') &&
        timeout 600 apt-get "$@" -qq download "$image" busybox-static &&
        vm_paths >paths &&
        dpkg-deb --fsys-tarfile "$image"_*.deb | tar -x --wildcards -T paths &&
        dpkg-deb --fsys-tarfile busybox-static_*.deb | tar -x ./bin/busybox &&
        mv boot/vmlinuz-* vmlinuz && version=$(ls lib/modules) &&
        depmod -b "$to" "$version" && rm -rf boot lists *.deb paths &&
        mv "lib/modules/$version" modules && rmdir lib/modules lib
)

# vm_modules ARCH MODULE...: their files, each behind the files it needs, none twice.
vm_modules()
(
    arch=$1; shift
    for module; do
        sed -n "s|^\([^:]*/$module\.ko\): *\(.*\)|\2 \1|p" \
            "$vm_folder/$arch/modules/modules.dep" |
            awk '{ for (i = NF - 1; i > 0; i--) print $i; print $NF }'
    done | awk '!seen[$0]++'
)

# vm_disk NAME ARCH CASES "MODULE..." PROGRAM...: makes a file system to boot,
# $vm_work/NAME.gz.
vm_disk()
(
    disk=$vm_work/$1 arch=$2 cases=$3 modules=$4; shift 4
    rm -rf "$disk" && mkdir -p "$disk/bin" "$disk/modules" "$disk/dev" "$disk/proc" \
        "$disk/sys" "$disk/tmp" || return 1
    cp "$vm_folder/$arch/bin/busybox" "$disk/bin" && cp "$cases" "$disk/cases" &&
        cp tests/boards/init.sh "$disk/init" && chmod +x "$disk/init" || return 1
    for program; do
        cp "$program" "$disk/bin" || return 1
    done
    i=100
    for module in $(vm_modules "$arch" $modules); do
        i=$((i + 1))
        cp "$vm_folder/$arch/modules/$module" "$disk/modules/$i-${module##*/}" || return 1
    done
    (cd "$disk" && find . | cpio -o -H newc --quiet | gzip -1) >"$disk.gz"
)

# Options of a machine, in addition to the test's options for the screen.
vm_machine()    # ARCH
{
    case $1 in
    amd64) echo qemu-system-x86_64 -M pc -cpu qemu64 -m 256 ;;
    arm64) echo qemu-system-aarch64 -M virt -cpu cortex-a53 -m 256 ;;
    esac
}
vm_console()    # ARCH
{
    case $1 in amd64) echo ttyS0 ;; arm64) echo ttyAMA0 ;; esac
}

# vm_boot NAME ARCH WORDS OPTION...: boots disk NAME with WORDS for the kernel, answers
# requests, and writes the machine's output to $vm_work/NAME.log. At most 90 s.
vm_boot()
(
    boot=$1 arch=$2 words=$3; shift 3
    quick="nokaslr mitigations=off"         # one second shorter
    port=$vm_work/$boot.port monitor=$vm_work/$boot.monitor log=$vm_work/$boot.log
    rm -f "$port.in" "$port.out" "$monitor"
    mkfifo "$port.in" "$port.out" "$monitor" || return 1
    exec 6<>"$port.in" 7<>"$port.out" 8<>"$monitor"
    {
        timeout --foreground -k 5 "${VM_TIMEOUT:-90}" $(vm_machine "$arch") \
            -display none -no-reboot -nodefaults \
            -kernel "$vm_folder/$arch/vmlinuz" -initrd "$vm_work/$boot.gz" \
            -append "console=$(vm_console "$arch") quiet panic=-1 $quick $words" \
            -serial "pipe:$port" -monitor stdio "$@" <&8 >"$monitor.log" 2>&1 6<&- 7<&-
        echo "vm: gone $?" >&7
    } &
    machine=$!
    vm_answer <&7 >"$log"
    answered=$?
    echo quit >&8
    wait "$machine"
    exec 6<&- 7<&- 8<&-
    [ $answered = 0 ] && return 0
    tail -n 20 "$log"
    grep -v "^(qemu)" "$monitor.log"
    return 1
)

# Reads the machine's lines, prints them, and carries out the requests.
vm_answer()
{
    while IFS= read -r line; do
        line=$(echo "$line" | tr -d '\r')
        echo "$line"
        case $line in
        *"vm: shot "*)
            vm_shot "${line##*vm: shot }" || return 1
            echo go >&6 ;;
        *"vm: key "*)
            echo "sendkey ${line##*vm: key }" >&8
            echo go >&6 ;;
        *"vm: end"*)  return 0 ;;
        *"vm: gone"*) return 1 ;;
        esac
    done
}

# vm_want NAME PICTURE [565 [centred]]: sets the expected picture of a dump.
vm_want()
(
    name=$1; shift
    echo "$*" >"$vm_work/$name.want"
)

# vm_same NAME: true if the dump equals the expected picture.
vm_same()
{
    "$TP_BUILD/tests/boards/same_picture" "$vm_work/$1.ppm" $(cat "$vm_work/$1.want")
}

# The monitor runs its commands in order: when NAME.done exists, NAME.ppm is complete.
vm_dump()       # NAME
{
    rm -f "$vm_work/$1.done"
    echo "screendump $vm_work/$1.ppm" >&8
    echo "pmemsave 0 1 \"$vm_work/$1.done\"" >&8
    for _ in $(seq 200); do
        [ -s "$vm_work/$1.done" ] && return 0
        sleep 0.05
    done
    echo "no dump of the screen"
    return 1
}

# A picture may reach the screen with a delay: an expected picture is waited for, at most
# five seconds.
vm_shot()       # NAME
{
    for _ in $(seq 50); do
        vm_dump "$1" || return 1
        [ ! -e "$vm_work/$1.want" ] || vm_same "$1" >/dev/null && return 0
        sleep 0.1
    done
}

# vm_results NAME: reports the results of a boot's cases as results of this test; a boot
# without results has failed.
vm_results()
{
    if ! grep -E '^(ok|FAILED) - ' "$vm_work/$1.log" >"$scratch/results"; then
        echo "FAILED - $1: no case was run"
        failures=$((failures + 1))
        return
    fi
    sed "s/^\(ok\|FAILED\) - /&$1: /" "$scratch/results"
    failures=$((failures + $(grep -c '^FAILED' "$scratch/results")))
}
