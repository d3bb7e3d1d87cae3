#!/bin/sh
# SPDX-License-Identifier: MIT
# Programs of other projects use the library by CMake's add_subdirectory, by find_package
# after `cmake --install` or `make install`, and by pkg-config.  All draw the same picture
# as the library built by make.
#     packages.sh PROGRAM
root=$PWD
kept=${TP_BUILD:-build/host}
build=$(realpath "$kept") || exit 2
version=$("$1" --version | sed -n '1s/tidepool //p')
example=$root/ports/examples/consumer
cc=${CC:-cc} cxx=${CXX:-c++}
. "$(dirname "$0")/../lib/script.sh"
program_begin "$1"

# Only the sources are present; the pipe to make's jobs is closed too.
unset MAKEFLAGS MAKELEVEL MFLAGS PKG_CONFIG_PATH CMAKE_PREFIX_PATH DESTDIR

# draws WHAT PROGRAM...: each prints version and CRC of the library built by make.
draws() {
    what=$1
    shift
    for sea; do
        same "$what: ${sea##*/} draws it" "$(timeout 60 "$sea" 2>&1)" "$wanted"
    done
}

$cc -std=c11 -I"$root/include" "$example/sea.c" "$build/libtidepool.a" -o sea 2>err ||
    { cat err; exit 1; }
wanted=$(./sea)
same "a program of the checkout has its version and a CRC" \
    "$(echo "$wanted" | grep -cx "$version [0-9a-f]\{8\}")" 1
same "an example has at most twelve statements and lines of declarations" \
    "$(for file in "$example"/sea.c*; do
           sed -n '/main/,$p' "$file" | grep -c ';' | awk '$1 > 12'
       done)" ""

# -- make install --------------------------------------------------------------------------

made=$work/root/opt/sea
make --no-print-directory -s -C "$root" BUILD="$kept" DESTDIR="$work/root" \
    PREFIX=/opt/sea install >err 2>&1
same "make install" "$?" 0

# by_pkg_config WHAT TREE: builds programs from nothing but the installed tree.
by_pkg_config() {
    PKG_CONFIG_PATH=$2/lib/pkgconfig
    export PKG_CONFIG_PATH
    same "$1: its version" "$(pkg-config --modversion tidepool 2>&1)" "$version"
    rm -f sea sea++
    $cc -std=c11 "$example/sea.c" $(pkg-config --cflags --libs tidepool) -o sea 2>err &&
        $cxx -std=c++11 "$example/sea.cpp" $(pkg-config --cflags --libs tidepool) \
            -o sea++ 2>>err
    same "$1: programs are built" "$?" 0
    draws "$1" ./sea ./sea++
    unset PKG_CONFIG_PATH
}
lacks pkg-config pkg-config "programs by pkg-config" ||
    by_pkg_config "make install, pkg-config" "$made"

lacks cmake cmake "programs by CMake" && { finish; exit; }

# by_find_package WHAT TREE
by_find_package() {
    rm -rf found
    cmake -S "$example" -B found -DCMAKE_PREFIX_PATH="$2" -DWANTED="$version" \
        >out 2>err && cmake --build found >>out 2>>err
    same "$1: programs are built" "$?" 0
    same "$1: by this tree" \
        "$(sed -n 's/^tidepool_DIR:PATH=//p' found/CMakeCache.txt)" "$2/lib/cmake/tidepool"
    draws "$1" found/sea found/sea++
}
by_find_package "make install, find_package" "$made"

# asks VERSION: true if find_package accepts the tree, in a project without a language.
mkdir asking
printf '%s\n' 'cmake_minimum_required(VERSION 3.13)' 'project(asking NONE)' \
    'find_package(tidepool ${WANTED} REQUIRED)' >asking/CMakeLists.txt
asks() {
    rm -rf asked
    cmake -S asking -B asked -DCMAKE_PREFIX_PATH="$made" -DWANTED="$1" >out 2>&1 &&
        echo taken || grep -o 'compatible with requested version' out
}
major=${version%%.*} rest=${version#*.}
minor=${rest%.*}
same "its own version is taken" "$(asks "$major.$minor")" taken
same "a later one is not" "$(asks "$major.$minor.99999")" "compatible with requested version"
older=$((major - 1)) newer=$((major + 1))
[ "$major" -gt 0 ] || older=0.$((minor - 1)) newer=0.$((minor + 1))
for other in $older $newer; do
    same "nor one that promises something else: $other" "$(asks $other)" \
        "compatible with requested version"
done

# -- CMake: one build is both added to a project and installed -------------------------------

cmake -S "$example" -B added -DTIDEPOOL="$root" -DTIDEPOOL_INSTALL=ON \
    -DCMAKE_BUILD_TYPE=None -DCMAKE_RULE_MESSAGES=OFF >out 2>err &&
    cmake --build added -j2 >>out 2>>err
same "add_subdirectory: programs are built" "$?" 0
draws add_subdirectory added/sea added/sea++

# Without a build: the defaults of the options.
cmake -S "$example" -B guest -DTIDEPOOL="$root" >out 2>err && cmake -S "$root" -B top >out 2>err
same "a guest installs nothing unless asked, a project by itself does" \
    "$(ls guest/tidepool/tidepool.pc top/tidepool.pc 2>&1 | grep -v cannot)" top/tidepool.pc
same "which is optimised" \
    "$(grep -rlsq -e '-O3' top --include=flags.make --include=build.ninja; echo $?)" 0

cmake --install added --prefix "$work/to" >out 2>err
same "cmake --install" "$?" 0
mv to moved
by_find_package "cmake --install, moved, find_package" "$work/moved"
lacks pkg-config pkg-config "what CMake installs by pkg-config" ||
    by_pkg_config "cmake --install, moved, pkg-config" "$work/moved"

tree() { (cd "$1" && find include lib | sort | grep -v '/host\.h$\|-host\.'); }
same "both ways install the same files" "$(tree moved)" "$(tree "$made")"
same "and say the same of them" "$(diff -r moved/lib/cmake "$made/lib/cmake"
    diff moved/lib/pkgconfig/tidepool.pc "$made/lib/pkgconfig/tidepool.pc"
    diff -r -x host.h moved/include "$made/include")" ""

finish
