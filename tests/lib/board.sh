# SPDX-License-Identifier: MIT
# shellcheck shell=sh disable=SC2034,SC2046,SC2154
# Emulated boards and machines: exact counts of instructions, budgets, linked pieces, live
# boards, and PCs with Debian's own kernel; read by `.` after script.sh.

# -- counted programs ----------------------------------------------------------------------

plugin=build/host/count.so

# emulate ELF SAID COUNTS: writes the program's output to SAID and the plugin's counts to
# COUNTS.
emulate()
{
    timeout 300 qemu-system-arm -M mps2-an386 -nographic -monitor none -serial null \
        -chardev file,id=said,path="$2" \
        -semihosting-config enable=on,target=native,chardev=said -kernel "$1" \
        -plugin $plugin 2>"$3" </dev/null
}

# counted m4|x86 PROGRAM: writes $scratch/said and $scratch/counts, on an emulated Cortex-M4
# (the board's compiler) or on this machine; both at -O2.
counted()
{
    case $1 in
    m4)
        emulate "build/cortex-m/$2.elf" "$scratch/said" "$scratch/counts" ;;
    x86)
        valgrind --tool=callgrind --callgrind-out-file="$scratch/dump" \
            --dump-before=count_section --collect-atstart=no --toggle-collect='run_*' \
            --compress-strings=no --compress-pos=no \
            "build/host/tests/charts/$2" >"$scratch/said" 2>"$scratch/words" &&
            awk -f tests/budgets/callgrind.awk "$scratch"/dump.* >"$scratch/counts" ;;
    *)
        echo "usage: $0 m4|x86 ..." >&2
        exit 2 ;;
    esac || { cat "$scratch"/words "$scratch"/said 2>/dev/null >&2; exit 1; }
}

# -- budgets -------------------------------------------------------------------------------
#
# The figures are the lines of $scratch/figures; $whole is 1 if all names must be present,
# $skip names measures that are not compared. tests/budgets/budgets.awk has the rule.

budgets_by()    # BUDGETS [VARIABLE]...
{
    of=$1
    shift
    awk -v whole="$whole" -v skip="$skip" "$@" -f tests/budgets/budgets.awk "$of" \
        "$scratch/figures"
}

# Checks a budget, and that budgets can fail: with budgets lowered by 2 % some must fail.
hold()          # BUDGETS
{
    awk -F, -v OFS=, '$3 ~ /^[0-9]/ { $3 /= 1.02 } { print }' "$1" >"$scratch/lower"
    refuse "budgets of 2 % less are missed" budgets_by "$scratch/lower"
    budgets_by "$1" || fail "$1"
}

rewrite()       # BUDGETS BUILD=COMPILER...
{
    of=$1
    budgets_by "$of" -v write=1 >"$scratch/budgets" || return 1
    shift
    for by; do
        sed -i "s/^\(# compiler ${by%%=*} .*\) .*/\1 $("${by#*=}" -dumpfullversion)/" \
            "$scratch/budgets"
    done
    cp "$scratch/budgets" "$of"
}

# pinned BUDGETS BUILD COMPILER: true if the compiler has the version that made the
# budgets; other versions are skipped.
pinned()
{
    want=$(sed -n "s/^# compiler $2 //p" "$1")
    here="${want% *} $("$3" -dumpfullversion)"
    [ "$here" = "$want" ] && return
    skip "budgets of $want, here $here" "${want% *}"
    return 1
}

# -- linked pieces -------------------------------------------------------------------------

# pieces_of ELF: modules, passes, stages, wave models, systems, parts and renderers.
pieces_of()
{
    arm-none-eabi-nm --defined-only "$1" | sed -n \
        's/.* [A-Za-z] \(tp_\(stage\|water\|move\|draw\|method\)_[a-z0-9_]*\)$/\1/p
         s/.* [Rr] \(tp_[a-z0-9_]*_\(module\|drawing\)\)$/\1/p' | sort -u
}

# listed BAKED.c: pieces named by its list.
listed()
{
    grep -o 'tp_[a-z0-9_]*' "$1" | sort -u
}

# links_no_more PIECES BAKED.c: each linked piece is listed, and at least one is linked.
links_no_more()
{
    listed "$2" >"$1.listed"
    [ -s "$1" ] && ! comm -23 "$1" "$1.listed" | grep .
}

# -- a live board, controlled over its serial port and its monitor -------------------------
#
#   board_begin ELF [OPTION]...  starts the board and waits for its "ok NAME"
#   ask LINE                     sends a line; prints its answer, or nothing after 10 s
#   monitor COMMAND              sends a command to the emulator
#   dump FILE                    waits for the picture of the screen
#   board_end                    ends the emulator
#
# The board's output is in $scratch/said. No run exceeds 60 s.

live_board=cortex-m/lm3s6965evb
live_elf=build/lm3s6965evb/scenes/tarn.elf
live_scene=ports/cortex-m/scenes/tarn.ini
emulator=
at_end board_end

board_begin()
{
    kernel=$1; shift
    rm -f "$scratch/serial" "$scratch/monitor.in" "$scratch/monitor.out"
    mkfifo "$scratch/serial" "$scratch/monitor.in" "$scratch/monitor.out"
    exec 3<>"$scratch/serial" 4<>"$scratch/monitor.in" 5<>"$scratch/monitor.out"
    : >"$scratch/said"
    cat <&5 >/dev/null 3>&- 4>&- &
    drain=$!
    timeout 60 qemu-system-arm -M lm3s6965evb -display none \
        -monitor "pipe:$scratch/monitor" -chardev stdio,id=serial,signal=off \
        -serial chardev:serial -kernel "$kernel" "$@" \
        <&3 >"$scratch/said" 2>"$scratch/emulator" 3>&- 4>&- 5>&- &
    emulator=$!
    until_true said_more 0
}

# Only complete lines are answers.
whole_lines()   { head -n "$(wc -l <"$scratch/said")" "$scratch/said"; }
answers()       { whole_lines | grep -c '^ok\|^error'; }
said_more()     { [ "$(answers)" -gt "$1" ]; }

ask()
{
    before=$(answers)
    printf '%s\n' "$1" >&3
    until_true said_more "$before"
    whole_lines | grep '^ok\|^error' | tail -n 1
}

monitor()       { printf '%s\n' "$1" >&4; }

is_whole()      { [ -f "$1" ] && [ "$(wc -c <"$1")" -eq 393231 ]; }    # 512 x 256
dump()
{
    rm -f "$1"
    monitor "screendump $1"
    until_true is_whole "$1"
}

board_end()
{
    [ "$emulator" ] || return 0
    kill "$emulator" "$drain" 2>/dev/null
    wait "$emulator" "$drain" 2>/dev/null
    emulator=
}

# Fields of the answer to `state`.
tick_of()       { echo "$1" | sed 's/ok tick \([0-9]*\).*/\1/'; }
crc_of()        { echo "$1" | sed 's/.* crc32 \([0-9a-f]*\).*/\1/'; }
bytes_of()      { echo "$1" | sed 's/.* bytes sent \([0-9]*\).*/\1/'; }
clocks_of()     { echo "$1" | sed 's/.* clocks \([0-9]*\).*/\1/'; }

# Prints the host's CRC at a tick, by the rungs that were planned for the baked scene.
host_crc()      # TICK [OPTION]...
{
    at=$1; shift
    # shellcheck disable=SC2046
    set -- $("$program" plan $live_scene --size 128x64 --csv |
        awk -F, '$3 == "chosen" { print "--set " $1 "=" $2 }') "$@"
    "$program" render $live_scene --size 128x64 --format l8 --frames "$at:$at" --hash "$@" |
        sed 's/.* //'
}

board_ready()   # WHAT: exits with 77 if a tool is missing; builds the program
{
    lacks qemu-system-arm qemu-system-arm "$1" && exit 77
    lacks arm-none-eabi-gcc gcc-arm-none-eabi "$1" && exit 77
    check "the board's program builds" alone build BOARD=$live_board SCENE=tarn elf
    [ $failed = 0 ] || exit 1
    check "the board starts" board_begin $live_elf
    [ $failed = 0 ] || exit 1
}

# -- machines with Debian's own kernel -----------------------------------------------------
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
               lacks aarch64-linux-gnu-gcc gcc-aarch64-linux-gnu "$name" && return 0
               lacks clang clang "$name" && return 0 ;;
        esac
        vm_kernel "$arch" >"$scratch/apt" 2>&1 && continue
        tail -n 3 "$scratch/apt"
        skip "$name" "linux-image-$arch"
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
    "build/host/tests/boards/same_picture" "$vm_work/$1.ppm" $(cat "$vm_work/$1.want")
}

# The monitor runs its commands in order: when NAME.done exists, NAME.ppm is complete.
vm_dump()       # NAME
{
    rm -f "$vm_work/$1.done"
    echo "screendump $vm_work/$1.ppm" >&8
    echo "pmemsave 0 1 \"$vm_work/$1.done\"" >&8
    until_true test -s "$vm_work/$1.done" && return 0
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
        fail "$1" "no case was run"
        return
    fi
    sed "s/^\(ok\|FAILED\) - /&$1: /" "$scratch/results"
    passed=$((passed + $(grep -c '^ok' "$scratch/results")))
    failed=$((failed + $(grep -c '^FAILED' "$scratch/results")))
}
