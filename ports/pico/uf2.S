/* SPDX-License-Identifier: MIT */
/* UF2 file of a flash image: the boot ROM of an RP2040 or RP2350 with BOOTSEL held is a USB
 * disk, and writes the blocks of such a file into the flash.  A block has 512 bytes: two
 * magic words, flags (2000h: the family is given), address, bytes, number, count, family,
 * 476 bytes of which 256 are used, a magic word.  IMAGE is the file, BLOCKS its bytes / 256,
 * FAMILY the number of the chip. */
    .section .uf2, "a"
    .set block, 0
    .rept BLOCKS
    .word 0x0a324655, 0x9e5d5157, 0x00002000
    .word 0x10000000 + 256 * block, 256, block, BLOCKS, FAMILY
    .incbin IMAGE, 256 * block, 256
    .fill 476 - 256
    .word 0x0ab16f30
    .set block, block + 1
    .endr
