/* SPDX-License-Identifier: MIT */
/* Start-up code that C cannot express: the first instructions, the switch to the privilege
 * level of an operating system (the firmware starts the program as a hypervisor, QEMU in
 * the secure world), exceptions, the memory map.  All cores but the first sleep.
 *
 * An exception calls fault(class, pc, address) on a separate stack; the class is that of
 * AArch64's ESR on both architectures.  A semihosting trap without a debugger or emulator
 * also arrives here and returns -1. */
    .section .start, "ax"
    .global _start, barrier, map_enable, semihost

#ifdef __aarch64__
_start:
    mrs     x0, mpidr_el1
    tst     x0, #3
    b.ne    park
    ldr     x0, =0x30d00800             /* no map, no caches */
    msr     sctlr_el1, x0
    adr     x1, el1
    mov     x2, #0x3c5                  /* EL1, own stack, interrupts masked */
    mrs     x0, CurrentEL
    cmp     x0, #2 << 2
    b.lo    el1
    mov     x3, #1 << 31                /* EL1 is 64-bit */
    msr     hcr_el2, x3
    b.eq    el2
    mov     x3, #0x431                  /* EL2 is 64-bit; non-secure */
    msr     scr_el3, x3
    msr     spsr_el3, x2
    msr     elr_el3, x1
    eret
el2:
    msr     spsr_el2, x2
    msr     elr_el2, x1
    eret
el1:
    ldr     x0, =vectors
    msr     vbar_el1, x0
    ldr     x0, =stack_top
    mov     sp, x0
    bl      reset
park:
    wfi
    b       park

barrier:
    dsb     sy
    ret

map_enable:
    msr     ttbr0_el1, x0
    ldr     x0, =0x0444ff               /* 0: cached; 1: uncached; 2: device */
    msr     mair_el1, x0
    ldr     x0, =0x800000 | (64 - 30)   /* 30 bits of address, one table */
    msr     tcr_el1, x0
    isb
    tlbi    vmalle1
    ic      iallu
    dsb     sy
    isb
    ldr     x0, =0x30d00800 | 0x1005    /* map, data and instruction caches */
    msr     sctlr_el1, x0
    isb
    ret

semihost:
    hlt     #0xf000
    ret

trap:
    mrs     x0, esr_el1
    mrs     x1, elr_el1
    mrs     x2, far_el1
    lsr     x0, x0, #26
    cbnz    x0, 1f                      /* class is not 0, undefined? */
    ldr     x3, =semihost
    cmp     x1, x3
    b.ne    1f
    add     x1, x1, #4
    msr     elr_el1, x1
    mov     x0, #-1
    eret
1:  ldr     x3, =fault_stack
    mov     sp, x3
    bl      fault

    .balign 2048
vectors:
    .rept   16
    b       trap
    .balign 128
    .endr

#else
    .arm
#if __ARM_ARCH >= 7
    .arch_extension virt
#define BARRIER dsb
#define FLUSH   isb
#define SLEEP   wfi
#else
#define BARRIER mcr p15, 0, r1, c7, c10, 4
#define FLUSH   mcr p15, 0, r1, c7, c5, 4
#define SLEEP   mcr p15, 0, r1, c7, c0, 4
#endif

_start:
#if __ARM_ARCH >= 7
    mrc     p15, 0, r0, c0, c0, 5
    tst     r0, #3
    bne     park
    mrs     r0, cpsr
    and     r0, r0, #0x1f
    cmp     r0, #0x1a                   /* hypervisor mode? */
    bne     1f
    mov     r0, #0xd3
    msr     spsr_cxsf, r0
    adr     r0, 1f
    msr     elr_hyp, r0
    eret
1:
#endif
    msr     cpsr_c, #0xd3               /* supervisor, interrupts masked */
    ldr     r0, =vectors
    mcr     p15, 0, r0, c12, c0, 0
    ldr     sp, =stack_top
    bl      reset
park:
    mov     r1, #0
    SLEEP
    b       park

barrier:
    mov     r1, #0
    BARRIER
    bx      lr

map_enable:
    mov     r1, #1
    mcr     p15, 0, r1, c3, c0, 0       /* one domain, permissions checked */
    mov     r1, #0
    mcr     p15, 0, r1, c2, c0, 2       /* one table */
    mcr     p15, 0, r0, c2, c0, 0
    mcr     p15, 0, r1, c8, c7, 0       /* invalidates the TLB, */
    mcr     p15, 0, r1, c7, c5, 0       /* the instruction cache */
#if __ARM_ARCH < 7
    mcr     p15, 0, r1, c7, c6, 0       /* and the data cache */
#endif
    BARRIER
    mrc     p15, 0, r0, c1, c0, 0
    bic     r0, r0, #0x30000000         /* entries as start.c writes them */
    bic     r0, r0, #0x2000             /* vectors at VBAR */
    bic     r0, r0, #2
    orr     r0, r0, #0xc00000
    orr     r0, r0, #0x1800             /* instruction cache, branch prediction */
    orr     r0, r0, #5                  /* MMU, data cache */
    mcr     p15, 0, r0, c1, c0, 0
    FLUSH
    bx      lr

semihost:
    push    {r4, lr}                    /* a trap without a debugger overwrites lr */
    svc     #0x123456
    pop     {r4, pc}

    .balign 32
vectors:
    b       _start
    b       undefined
    b       call
    b       instruction
    b       data
    b       other
    b       other
    b       other

undefined:
    mov     r0, #0
    sub     r1, lr, #4
    mov     r2, #0
    b       told
call:
    mvn     r0, #0
    movs    pc, lr
instruction:
    mov     r0, #0x21
    sub     r1, lr, #4
    mov     r2, r1
    b       told
data:
    mov     r0, #0x25
    sub     r1, lr, #8
    mrc     p15, 0, r2, c6, c0, 0
    b       told
other:
    mov     r0, #0x3f
    sub     r1, lr, #4
    mov     r2, #0
told:
    ldr     sp, =fault_stack
    bl      fault
#endif
