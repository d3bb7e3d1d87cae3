#!/bin/sh
# SPDX-License-Identifier: MIT
# DRM mode setting of Debian kernels, on an emulated PC (bochs) and an emulated aarch64
# board (virtio-gpu): the screen, dumped from outside of the machine, equals the golden
# frame and the host's picture, pixel by pixel. The same by /dev/fb0 with two pages,
# between which these drivers cannot pan although they report that they can.
#
#   tests/boards/kms.sh [PROGRAM]
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/board.sh"

program=${1:-build/host/tidepool}
scene=three-swells golden=tests/golden/three-swells/xrgb8888-0100.png

vm_lacks "screens by KMS" amd64 arm64 && exit 0
check "one static file shows a scene" alone build build/host/scenes/$scene-screen
check "and one for aarch64" for_aarch64 build/$aarch64/scenes/$scene-screen
check "the host's picture" "$program" render $scene --rung named --size 640x480 --frames 3:3 \
    --out "$vm_work/whole.png"
[ "$failed" = 0 ] || exit 1

cat >"$scratch/cases" <<'EOF'
show whole three-swells-screen --on kms --frames 3:3 --size 640x480
show golden three-swells-screen --on kms --frames 100:100 --size 208x150
check "its frame buffer has two pages" \
    grep -q "^1280,1600$" /sys/class/graphics/fb0/virtual_size
show page three-swells-screen --on fb --frames 3:3 --size 640x480
EOF

machine()       # NAME ARCH MODULES CASES PROGRAM QEMU'S-OPTION...
{
    machine=$1 arch=$2 modules=$3 cases=$4 binary=$5; shift 5
    vm_want $machine-whole "$vm_work/whole.png" 888
    vm_want $machine-golden $golden 888 centred
    vm_want $machine-page "$vm_work/whole.png" 888 centred
    vm_disk $machine $arch "$cases" "$modules" "$binary"
    check "$machine: the machine boots" vm_boot $machine $arch \
        "boot=$machine module_words=drm_fbdev_overalloc=200" "$@"
    vm_results $machine
    check "$machine: the host's picture on the whole screen" vm_same $machine-whole
    check "$machine: the golden frame in its middle" vm_same $machine-golden
    check "$machine: the host's picture by its frame buffer" vm_same $machine-page
}

machine bochs amd64 bochs "$scratch/cases" build/host/scenes/$scene-screen -vga std
machine virtio arm64 "virtio_pci virtio-gpu" "$scratch/cases" \
    build/$aarch64/scenes/$scene-screen -vga none -device virtio-gpu-pci

vm_want virtio-golden tests/golden/$scene/xrgb8888-0000.png 888 centred
refuse "another frame than the golden one is found" vm_same virtio-golden
finish
