/* SPDX-License-Identifier: MIT */
/* Boot stage 2 of the RP2040: the boot ROM copies these 256 bytes to the end of the RAM,
 * checks them and calls them.  They let the processor read and execute the flash in place,
 * then start the program behind them.
 *
 * The flash is a W25Q16JV or a chip with its commands.  Reads are EBh, quad I/O, with the
 * mode bits A0h: a read after a read sends address, mode bits and four dummy clocks only,
 * 20 clocks for a word.  The clock is half of the system's, 66 MHz at 133 MHz, and data are
 * sampled one system clock late.  The bit QE, which frees the chip's pins 2 and 3, is set in
 * the volatile copy of the status, if it is not set yet.
 *
 * The last word is the CRC-32 of the 252 bytes before (polynomial 04C11DB7h, from all
 * ones, neither reflected nor inverted).  tests/boards/pico.sh computes it anew. */
    .syntax unified
    .cpu    cortex-m0plus
    .thumb

    .equ SSI,           0x18000000  /* the serial interface of the flash */
    .equ CTRLR0,        0x00
    .equ CTRLR1,        0x04
    .equ ENABLE,        0x08
    .equ DIVISOR,       0x14
    .equ STATUS,        0x28
    .equ DATA,          0x60
    .equ SAMPLE_DELAY,  0xf0
    .equ SPI_CTRLR0,    0xf4
    .equ VTOR,          0xe000ed08
    .equ VECTORS,       0x10000100

    .equ BYTES,         7 << 16                     /* serial frames of 8 bits */
    .equ QUAD_WORDS,    2 << 21 | 31 << 16 | 3 << 8 /* quad frames of 32 bits, reads */
    .equ WITH_COMMAND,  4 << 11 | 2 << 8 | 8 << 2 | 1       /* serial command first */
    .equ NO_COMMAND,    0xa0 << 24 | 4 << 11 | 8 << 2 | 2   /* address and mode A0h */

    .section .boot2, "ax"
    .global boot2
    .type   boot2, %function
boot2:
    ldr   r4, =SSI
    movs  r5, #0
    movs  r6, #1
    str   r5, [r4, #ENABLE]         /* registers change while it is off */
    movs  r0, #2
    str   r0, [r4, #DIVISOR]
    movs  r1, #SAMPLE_DELAY
    str   r6, [r4, r1]
    ldr   r0, =BYTES
    str   r0, [r4, #CTRLR0]
    str   r6, [r4, #ENABLE]

    movs  r0, #0x35                 /* status 2: bit 1 is QE */
    bl    exchange
    movs  r1, #2
    tst   r0, r1
    bne   enter
    movs  r0, #0x50                 /* the next write is volatile */
    str   r0, [r4, #DATA]
    bl    settle
    ldr   r0, [r4, #DATA]
    movs  r0, #0x31                 /* status 2: QE */
    movs  r1, #2
    bl    exchange
1:  movs  r0, #0x05                 /* status 1: bit 0 is set while it writes */
    bl    exchange
    tst   r0, r6
    bne   1b

enter:                              /* a read that keeps the chip in quad reads */
    str   r5, [r4, #ENABLE]
    ldr   r0, =QUAD_WORDS
    str   r0, [r4, #CTRLR0]
    str   r5, [r4, #CTRLR1]         /* one word a read */
    movs  r1, #SPI_CTRLR0
    ldr   r0, =WITH_COMMAND
    str   r0, [r4, r1]
    str   r6, [r4, #ENABLE]
    movs  r0, #0xeb
    str   r0, [r4, #DATA]
    movs  r0, #0xa0                 /* address 0, mode bits */
    str   r0, [r4, #DATA]
    bl    settle
    str   r5, [r4, #ENABLE]
    movs  r1, #SPI_CTRLR0
    ldr   r0, =NO_COMMAND
    str   r0, [r4, r1]
    str   r6, [r4, #ENABLE]

    ldr   r0, =VECTORS
    ldr   r1, =VTOR
    str   r0, [r1]
    ldr   r1, [r0]
    mov   sp, r1
    ldr   r0, [r0, #4]
    bx    r0

exchange:                           /* sends r0, r1; returns the second received byte */
    mov   r7, lr
    str   r0, [r4, #DATA]
    str   r1, [r4, #DATA]
    bl    settle
    ldr   r0, [r4, #DATA]
    ldr   r0, [r4, #DATA]
    bx    r7

settle:                             /* waits: nothing to send, and not busy */
    ldr   r2, [r4, #STATUS]
    movs  r3, #5
    ands  r2, r3
    cmp   r2, #4
    bne   settle
    bx    lr

    .ltorg
    .org  252
    .word 0x0a0c8c9e
