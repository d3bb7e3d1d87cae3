#!/bin/sh
# SPDX-License-Identifier: MIT
# Installs missing packages on Debian or Ubuntu, and prints each with its purpose.
#
#   ports/setup.sh run|test|gallery|bench|web|serve|all
#
# Groups: `run` to build and show, `test` for the host's tests too, `gallery` to take the
# pictures, `bench` for renderers to compare with, `web` to make the page, `serve` to serve
# the page, `all` for tests on other processors, boards, windows and the page too.
# Without apt or root (sudo -n is tried) it prints the exact command.  It then stops with 3
# if a package is needed to build.  If a package is needed by tests only, it goes on, and
# the tests report that they were skipped.
set -u

# group | package | test for its presence | purpose
packages='
run  | gcc                       | cmd gcc                     | the compiler
run  | libc6-dev                 | inc stdio.h                 | headers of the C library
run  | pkg-config                | cmd pkg-config              | finds the libraries
run  | libpng-dev                | pkg libpng                  | textures in, pictures out
run  | libinih-dev               | pkg inih                    | scene files
show | libsdl2-dev               | pkg sdl2                    | the preview window
show | libimgui-dev              | pkg imgui                   | its panel
show | g++                       | cmd g++                     | its compiler
test | libdrm-dev               | inc libdrm/drm.h            | headers of raw screens
test | libcmocka-dev             | pkg cmocka                  | unit tests
test | cmake                    | cmd cmake                   | package of the library
test | g++                      | cmd g++                     | a program in C++ with it
test | binutils                  | cmd objdump                 | gates on the object code
test | mandoc                    | cmd mandoc                  | checks the manual page
test | xvfb                     | cmd Xvfb                    | a display that is taken away
sheet | imagemagick              | cmd montage                 | lays pictures out
sheet | fonts-dejavu-core        | dir /usr/share/fonts/truetype/dejavu | their names
sheet | xvfb                     | cmd Xvfb                    | a display for the preview
sheet | xdotool                  | cmd xdotool                 | its keys
peers | libosmesa6-dev           | pkg osmesa                  | Mesa, to compare with
peers | libsdl2-dev              | pkg sdl2                    | SDL, to compare with
peers | valgrind                 | cmd valgrind                | counts instructions
page | clang                     | cmd clang                   | the second compiler; the page
page | lld                       | cmd wasm-ld                 | links it
page | binaryen                  | cmd wasm-opt                | makes it smaller
node | nodejs                    | cmd node                    | serves it, and tests it
all  | npm                       | cmd npm                     | fetches what drives a browser
all  | chromium                  | cmd chromium                | shows the page in tests
all  | libclang-rt-dev           | lib clang_rt.fuzzer         | fuzzing
all  | libsdl2-dev               | pkg sdl2                    | the preview window
all  | libimgui-dev              | pkg imgui                   | its panel
all  | g++                       | cmd g++                     | its compiler
all  | valgrind                  | cmd valgrind                | counts instructions
all  | gcc-arm-none-eabi         | cmd arm-none-eabi-gcc       | Cortex-M
all  | qemu-system-arm           | cmd qemu-system-arm         | Cortex-M boards
all  | qemu-user                 | cmd qemu-s390x              | other processors
all  | gcc-i686-linux-gnu        | cmd i686-linux-gnu-gcc      | i386
all  | gcc-arm-linux-gnueabihf   | cmd arm-linux-gnueabihf-gcc | armhf
all  | gcc-aarch64-linux-gnu     | cmd aarch64-linux-gnu-gcc   | aarch64
all  | gcc-riscv64-linux-gnu     | cmd riscv64-linux-gnu-gcc   | riscv64
all  | gcc-s390x-linux-gnu       | cmd s390x-linux-gnu-gcc     | s390x, big-endian
all  | libc6-dev-i386-cross      | dir /usr/i686-linux-gnu/include      | i386
all  | libc6-dev-armhf-cross     | dir /usr/arm-linux-gnueabihf/include | armhf
all  | libc6-dev-arm64-cross     | dir /usr/aarch64-linux-gnu/include   | aarch64
all  | libc6-dev-riscv64-cross   | dir /usr/riscv64-linux-gnu/include   | riscv64
all  | libc6-dev-s390x-cross     | dir /usr/s390x-linux-gnu/include     | s390x
all  | xvfb                      | cmd Xvfb                    | a display for the preview
all  | xdotool                   | cmd xdotool                 | its keys and mouse
all  | gnuplot-nox               | cmd gnuplot                 | draws the charts
all  | parallel                  | gnu parallel                | runs their jobs anywhere
all  | procps                    | cmd pgrep                   | finds its process
all  | qemu-system-x86           | cmd qemu-system-x86_64      | Linux, for its screens
all  | cpio                      | cmd cpio                    | its file system
all  | kmod                      | cmd kmod                    | its modules
all  | imagemagick               | cmd import                  | its screenshots
all  | sweethome3d-furniture     | dir /usr/share/sweethome3d/furniture | 820 meshes to draw
all  | unzip                     | cmd unzip                   | unpacks them
'

present()       # KIND NAME
{
    case $1 in
    cmd) command -v "$2" >/dev/null ;;
    pkg) pkg-config --exists "$2" 2>/dev/null ;;
    gnu) "$2" --version 2>/dev/null </dev/null | grep -q GNU ;;
    inc) echo "#include <$2>" | gcc -E - >/dev/null 2>&1 ;;
    dir) [ -d "$2" ] ;;
    lib) find /usr/lib /usr/lib/llvm-* -name "*$2*.a" 2>/dev/null | grep -q . ;;
    esac
}

case ${1:-} in
run)  groups='run show' ;;
test) groups='run show test' ;;
gallery) groups='run show sheet' ;;
bench) groups='run peers' ;;
web)  groups='page' ;;
serve) groups='page node' ;;
all)  groups='run test page node all' ;;
*)    sed -n '3,12s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac

missing= needed=
while IFS='|' read -r group package check why; do
    group=${group%% *} package=$(echo $package)
    case " $groups " in *" $group "*) ;; *) continue ;; esac
    [ -z "$package" ] || present $check && continue
    echo "missing: $package -$why"
    missing="$missing $package"
    [ "$group" != run ] || needed="$needed $package"
done <<EOF
$packages
EOF
[ -n "$missing" ] || exit 0

install="apt-get install -y --no-install-recommends$missing"
as=
if [ "$(id -u)" -ne 0 ]; then
    if sudo -n true 2>/dev/null; then as='sudo -n'; else as=none; fi
fi
if command -v apt-get >/dev/null && [ "$as" != none ]; then
    echo "installing:$missing"
    $as apt-get update -qq
    if $as env DEBIAN_FRONTEND=noninteractive $install -qq >/dev/null; then
        exit 0
    fi
    echo "the installation failed" >&2
fi
echo "please run:  sudo $install" >&2
[ -z "$needed" ] || exit 3
