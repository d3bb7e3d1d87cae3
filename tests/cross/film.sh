#!/bin/sh
# SPDX-License-Identifier: MIT
# A film whose ranges were drawn on two machines, this machine and an emulated aarch64,
# has the bits of a single run.
#     film.sh PROGRAM
. "$(dirname "$0")/../lib/script.sh"

program=$1
scenes='storm raindrops'
size=96x72
triple=aarch64-linux-gnu

lacks $triple-gcc gcc-$triple "a film of ranges from two machines" && exit 0
lacks clang clang "a film of ranges from two machines" && exit 0
lacks qemu-aarch64 qemu-user "a film of ranges from two machines" && exit 0
if [ ! -d /usr/$triple/include ]; then
    skip "a film of ranges from two machines" "libc6-dev-arm64-cross"
    exit 0
fi

goals=
for scene in $scenes; do
    goals="$goals build/$aarch64/tests/cross/film-$scene"
done
here()          # RANGE FILE
{
    "$program" render "$scene" --rung named --size $size --frames "$1" --out "$scratch/$2"
}
there()
{
    qemu-aarch64 "build/$aarch64/tests/cross/film-$scene" $size "$1" "$scratch/$2"
}
joined()        # PART...: joined, they equal the single run
{
    (cd "$scratch" && "$program" join film.y4m "$@" && cmp film.y4m all.y4m)
}
differs()       # PART...: joined, they make a different film
{
    (cd "$scratch" && "$program" join film.y4m "$@" && ! cmp -s film.y4m all.y4m)
}
program=$(realpath "$program")
check "the programs for aarch64 are built" for_aarch64 $goals
for scene in $scenes; do
    check "$scene: a single run" here 0:23 all.y4m
    check "$scene: frames 0 to 8, here" here 0:8 a.y4m
    check "$scene: frames 9 to 16, by aarch64" there 9:16 b.y4m
    check "$scene: frames 17 to 23, here" here 17:23 c.y4m
    check "$scene: joined, they are the single run" joined a.y4m b.y4m c.y4m
    check "$scene: in another order they are not" differs b.y4m a.y4m c.y4m
    check "$scene: nor without a part" differs a.y4m c.y4m
    check "$scene: frames 0 to 8, by aarch64" there 0:8 a.y4m
    check "$scene: it goes on from either machine" joined a.y4m b.y4m c.y4m
done
finish
