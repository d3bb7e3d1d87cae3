#!/bin/sh
# SPDX-License-Identifier: MIT
# Outputs of `tidepool render`: default names, animated PNGs, every Nth frame only.
#     output.sh PROGRAM
run_script=$(realpath ports/run.sh) || exit 2
build=$(realpath "${TP_BUILD:-build/host}") || exit 2
. "$(dirname "$0")/../lib/script.sh"
program_begin "$1"
apng_frames=$build/tests/host/apng_frames
left() {        # prints all files here but the test's own
    ls -A | grep -v -e '^out$' -e '^err$' | tr '\n' ' '
}

# -- without an output ------------------------------------------------------------------

mkdir sub
echo '; a scene' >sub/my.ini
cp sub/my.ini 100%.ini
mkdir here
cd here || exit 2
expect "a picture is called after its scene, and told" 0 \
    "^minimal.png: frame 0, 640x480$" render minimal
same "and is all there is" "$(wc -l <err) $(left)" "1 minimal.png "
run render minimal --out other.png
same "it is the picture of --out" "$(cmp minimal.png other.png)" ""
expect "a scene by its path: into this folder" 0 "^my.png: frame 7, 64x48$" \
    render ../sub/my.ini --size 64x48 --frames 7:7
run render ../sub/my.ini --size 64x48 --frames 7:7 --out other.png
same "it is that frame" "$(cmp my.png other.png)" ""
expect "a name with a percent sign" 0 "^100%.png: frame 0, 16x16$" \
    render ../100%.ini --size 16x16
expect "several frames are a film" 0 "^minimal.apng: frames 0..5, 64x48, 60 a second$" \
    render minimal --size 64x48 --frames 6
expect "some of them" 0 "^minimal.apng: frames 30..40, 64x48, 12 a second$" \
    render minimal --size 64x48 --frames 30:44 --every 5 --set wave0.amplitude=0.2
expect "at an uneven pace" 0 "^minimal.apng: frames 0..7, 64x48, each for 7/60 s$" \
    render minimal --size 64x48 --frames 8 --every 7
same "nothing else was made" "$(left)" \
    "100%.png minimal.apng minimal.png my.png other.png "
rm ./*png
echo "frame 0000 crc32 00000000" >../list
run render minimal --size 64x48 --hash
run render minimal --size 64x48 --stats
run render minimal --size 64x48 --expect ../list
run render minimal --size 64x48 --frames 3 --hash --tape nowhere
run render nowhere.ini
run render minimal --memory 1k
same "what was not asked for, or fails, leaves none" "$(left)" ""

"$program" render minimal --size 64x48 --format p8 >../told 2>&1
cp minimal.png mine.png
expect "a picture of ours is replaced" 0 "frame 9" render minimal --size 64x48 \
    --frames 9:9
same "by another one" "$(cmp -s minimal.png mine.png; echo $?)" 1
for old in "no PNG at all" "$(printf '\211PNG\r\n\032\n') of another program"; do
    printf '%s' "$old" >minimal.png
    cp minimal.png before
    expect "$(printf '%.12s' "$old" | tr -dc ' A-z'): none of ours is kept" 3 \
        "^minimal.png: exists, and tidepool did not make it; --out minimal.png rep" \
        render minimal --size 64x48
    same "as it was" "$(cmp minimal.png before)" ""
done
expect "--out replaces it" 0 "" render minimal --size 64x48 --out minimal.png
expect "and then it is ours" 0 "frame 0" render minimal --size 64x48
rm minimal.png
mkdir minimal.png minimal.apng
expect "a folder of that name" 3 "^minimal.png: exists" render minimal --size 64x48
expect "and of a film's" 3 "^minimal.apng: exists" render minimal --size 64x48 \
    --frames 2
cd .. || exit 2
rm -r here

# -- animated PNGs ----------------------------------------------------------------------

# film NAME FRAMES ARGUMENT...: expects the hashed frames, with their CRCs.
film() {
    name=$1 count=$2
    shift 2
    run render "$@" --hash --out film.apng
    told=$code
    awk '{ print $4 }' out >wanted
    "$apng_frames" film.apng >frames 2>&1
    code=$?
    awk '/^frame/ { print $4 }' frames >got
    same "$name: a well formed film of the frames that were hashed" \
        "$told $code $(wc -l <wanted) $(cmp wanted got 2>&1)" "0 0 $count "
}
for format in xrgb8888 rgb565 rgb565be p8 l8 i1; do
    film $format 5 three-swells --size 53x41 --frames 5 --format $format
    same "$format: it says its size, and that it has no end" "$(head -1 frames)" \
        "53x41, 5 frames, for ever"
    same "$format: each for a tick" "$(sed -n '/^frame/s/.* for \(.*\) s.*/\1/p' frames |
        sort -u)" 0.0167
done
film "each third" 4 storm --size 64x48 --frames 5:16 --every 3
same "each third: 20 a second" "$(sed -n '/^frame/s/.* for \(.*\) s.*/\1/p' frames |
    sort -u)" 0.0500
film "one frame" 1 storm --size 64x48 --frames 9:9
film "one frame of each 3600" 1 storm --size 64x48 --frames 2 --every 3600
same "it stands for a minute" "$(grep -c 'for 60.0000 s' frames)" 1
film "still water" 3 minimal --size 64x48 --frames 3 --set wave0.amplitude=0 \
    --set layer0.drift_x=0 --set layer0.drift_z=0
same "still water: later frames carry a row" "$(sed -n '/^frame/s/.*, //p' frames |
    tr '\n' ' ')" "48 rows 1 rows 1 rows "
film "a moving camera" 3 deep-sea --size 64x48 --frames 300:302 --set camera.follow=boat
run render three-swells --size 320x240 --format rgb565 --frames 0:177 --every 3 \
    --out big.apng
same "what make run leaves stays within 4 MB" "$code $(($(wc -c <big.apng) < 4000000))" \
    "0 1"
rm -f big.apng film.apng

ln -s /dev/full full.apng
expect "a full disk" 3 "^full.apng: No space" render storm --size 64x48 --frames 9 \
    --out full.apng
(ulimit -f 8; timeout $limit "$program" render storm --frames 99 --out big.apng 2>err)
code=$?
judge "a film beyond the size limit" 3 "^big.apng: File too large"
timeout 60 "$program" render storm --size 64x48 --frames 1000000 --out long.apng 2>err &
child=$!
for _ in 1 2 3 4 5 6 7 8 9; do
    ls -A | grep -q tidepool- && break
    sleep 0.1
done
kill $child
wait $child 2>/dev/null
same "films that fail or are stopped leave nothing" \
    "$(ls -A | grep -e big.apng -e long.apng -e tidepool-)" ""

# -- make run without a display ---------------------------------------------------------

# runs NAME=VALUE...: runs `make run` without a display and prints its end.
runs() {
    rm -rf out.d
    mkdir out.d
    (cd out.d && env -u DISPLAY -u WAYLAND_DISPLAY -u SDL_VIDEODRIVER "$@" "$run_script" \
        "$program" tank) >told 2>err </dev/null
    code=$?
}
runs A=b
same "it leaves a picture and a film, and says where" \
    "$code $(cd out.d && find . -type f | sort | tr '\n' ' ') \
$(grep -c "^  $PWD/out.d/out/tank.png: a picture" told) \
$(grep -c "^  $PWD/out.d/out/tank.apng: 3 seconds.* [0-9.]* MB;$" told)" \
    "0 ./out/tank.apng ./out/tank.png  1 1"
same "the film is of 60 frames at 20 a second" "$("$apng_frames" out.d/out/tank.apng |
    sed -n '1p; $s/.*for \(.*\) s.*/\1/p' | tr '\n' ' ')" \
    "320x240, 60 frames, for ever 0.0500 "
same "all of it is small" "$(($(cat out.d/out/* | wc -c) < 6000000))" 1
runs DISPLAY=:9797 SDL_VIDEODRIVER=x11 LSAN_OPTIONS=exitcode=0     # leaks of libraries
same "a display that is gone: the same" "$code $(ls out.d/out | tr '\n' ' ')" \
    "0 tank.apng tank.png "
rm -r out.d

# -- every Nth frame --------------------------------------------------------------------

for every in 0 -1 3601 x 1.5; do
    expect "--every $every" 2 "expected 1..3600" render minimal --every $every
done
run render storm --size 32x32 --frames 12 --hash
awk '$2 % 3 == 2' out >wanted
run render storm --size 32x32 --frames 2:11 --every 3 --hash
same "each third from the second on: the same frames" "$code $(cmp out wanted)" "0 "
run render storm --size 32x32 --frames 7 --every 3 --out f-%d.png
same "as pictures" "$code $(echo f-*)" "0 f-0.png f-3.png f-6.png"
expect "one picture needs no number" 0 "" render storm --size 32x32 --frames 3 --every 3 \
    --out one.png
run render storm --size 32x32 --frames 12 --every 3 --out all.y4m
same "a film tells its pace" "$(head -1 all.y4m | cut -d' ' -f4)" F60:3
header=$(head -1 all.y4m | wc -c)
same "and has those frames" "$(wc -c <all.y4m)" $((header + 4 * (6 + 32 * 32 * 3 / 2)))
run render storm --size 32x32 --frames 0:5 --every 3 --out a.y4m
run render storm --size 32x32 --frames 6:11 --every 3 --out b.y4m
run join joined.y4m a.y4m b.y4m
same "parts of it are joined" "$code $(cmp joined.y4m all.y4m)" "0 "
run render storm --size 32x32 --frames 6:11 --out c.y4m
expect "parts of another pace are not" 3 "its head differs from that of a.y4m" \
    join joined.y4m a.y4m c.y4m

finish
