/* SPDX-License-Identifier: MIT */
/* Arithmetic that the compiler calls: products to 64 bits in half the cycles of the
 * compiler's own function, and quotients from the divider that each core has.
 *
 * A division is no part of an interrupt handler: it would disturb a division that the
 * interrupt stopped. */
    .syntax unified
    .cpu    cortex-m0plus
    .thumb
    .text

    .macro function names:vararg
    .balign 4
    .irp  name, \names
    .global \name
    .type \name, %function
    .thumb_func
\name:
    .endr
    .endm

/* Low 64 bits of (r1 r0) (r3 r2).  With halves a0 a1 of r0 and b0 b1 of r2 the product of
 * the low words is a0 b0 + (a0 b1 + a1 b0) 2^16 + a1 b1 2^32. */
    function __aeabi_lmul, __muldi3
    push  {r4, r5, lr}
    muls  r1, r2
    muls  r3, r0
    adds  r1, r3                    /* the high words' part */
    lsrs  r3, r0, #16               /* a1 */
    uxth  r0, r0                    /* a0 */
    lsrs  r4, r2, #16               /* b1 */
    uxth  r2, r2                    /* b0 */
    mov   r5, r0
    muls  r5, r2                    /* a0 b0 */
    muls  r0, r4                    /* a0 b1 */
    muls  r4, r3                    /* a1 b1 */
    muls  r2, r3                    /* a1 b0 */
    adds  r1, r4
    movs  r3, #0
    adds  r0, r2                    /* the middle, 33 bits */
    adcs  r3, r3
    lsls  r3, r3, #16
    adds  r1, r3
    lsrs  r3, r0, #16
    adds  r1, r3
    movs  r3, #0
    lsls  r0, r0, #16
    adds  r0, r5
    adcs  r1, r3
    pop   {r4, r5, pc}

    .equ DIVIDER,   0xd0000060
    .equ UNSIGNED,  0x00            /* dividend; the divisor follows and starts it */
    .equ SIGNED,    0x08
    .equ QUOTIENT,  0x10
    .equ REMAINDER, 0x14

/* Quotient in r0, remainder in r1, after eight cycles. */
    .macro divide kind
    ldr   r2, =DIVIDER
    str   r0, [r2, #\kind]
    str   r1, [r2, #\kind + 4]
    .rept 4
    b     . + 2                     /* two cycles */
    .endr
    ldr   r1, [r2, #REMAINDER]
    ldr   r0, [r2, #QUOTIENT]
    bx    lr
    .endm

    function __aeabi_uidiv, __aeabi_uidivmod, __udivsi3
    divide UNSIGNED
    function __aeabi_idiv, __aeabi_idivmod, __divsi3
    divide SIGNED
