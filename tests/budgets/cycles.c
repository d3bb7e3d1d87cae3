/* SPDX-License-Identifier: MIT */
/* A QEMU plugin that counts the cycles of code for a Cortex-M0+ and for a Cortex-M0, with
 * memory that never waits and the multiplier of one cycle.  The emulated program controls
 * the count by the functions of count.c.  At the end the plugin prints a line
 *     cycles ACCOUNT INSTRUCTIONS M0PLUS_CYCLES M0_CYCLES
 * for each account.
 *
 * Cycles are those of the Cortex-M0+ and Cortex-M0 Technical Reference Manuals, table 3-1:
 * 1, loads and stores 2, of N registers 1 + N, branches 2 (M0: 3), BL 3 (4), POP to the
 * program counter 3 + N (4 + N); conditional branches 1 if not taken.  A conditional branch
 * ends a block: it was taken if the next block begins elsewhere. */
#include <inttypes.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* -- QEMU's interface, see count.c ------------------------------------------------- */

#define EXPORT __attribute__((visibility("default")))

typedef uint64_t plugin_id;
struct qemu_plugin_tb;
struct qemu_plugin_insn;
enum { NO_REGISTERS = 0 };

typedef void block_call(unsigned cpu, void *data);
typedef void translate_call(plugin_id, struct qemu_plugin_tb *);
typedef void exit_call(plugin_id, void *data);

void qemu_plugin_register_vcpu_tb_trans_cb(plugin_id, translate_call *);
void qemu_plugin_register_atexit_cb(plugin_id, exit_call *, void *data);
void qemu_plugin_register_vcpu_tb_exec_cb(struct qemu_plugin_tb *, block_call *,
                                          int registers, void *data);
size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *);
struct qemu_plugin_insn *qemu_plugin_tb_get_insn(const struct qemu_plugin_tb *, size_t);
const char *qemu_plugin_insn_symbol(const struct qemu_plugin_insn *);
uint64_t qemu_plugin_insn_vaddr(const struct qemu_plugin_insn *);
const void *qemu_plugin_insn_data(const struct qemu_plugin_insn *);
size_t qemu_plugin_insn_size(const struct qemu_plugin_insn *);

EXPORT extern int qemu_plugin_version;
int qemu_plugin_version = 1;

/* -- cycles of an instruction ------------------------------------------------------ */

typedef struct { uint64_t instructions, m0plus, m0; } cycles;

static unsigned bits_of(unsigned list)
{
    unsigned count = 0;

    for (; list; list &= list - 1)
        count++;
    return count;
}

/* Returns the cycles of an instruction by its first half; conditional branches as if not
 * taken. */
static cycles cycles_of(unsigned half)
{
    const unsigned high = half >> 8;

    if (half >= 0xf000)                                     /* BL; MRS, MSR, barriers */
        return (cycles){ 1, 3, 4 };
    if (high >= 0x48 && high <= 0x9f)                       /* LDR, STR */
        return (cycles){ 1, 2, 2 };
    if ((high & 0xfe) == 0xb4)                              /* PUSH */
        return (cycles){ 1, 1 + bits_of(half & 0x1ff), 1 + bits_of(half & 0x1ff) };
    if (high == 0xbd)                                       /* POP to the counter too */
        return (cycles){ 1, 3 + bits_of(half & 0x1ff), 4 + bits_of(half & 0x1ff) };
    if (high == 0xbc || (high & 0xf0) == 0xc0)              /* POP, LDM, STM */
        return (cycles){ 1, 1 + bits_of(half & 0xff), 1 + bits_of(half & 0xff) };
    if ((high & 0xf8) == 0xe0 || high == 0x47)              /* B, BX, BLX */
        return (cycles){ 1, 2, 3 };
    if ((high == 0x46 || high == 0x44) && (half & 0x87) == 0x87)    /* to the counter */
        return (cycles){ 1, 2, 3 };
    return (cycles){ 1, 1, 1 };
}

/* -- counts ------------------------------------------------------------------------ */

enum { ACCOUNTS = 8 };

typedef struct {
    cycles      own;
    uint64_t    start, next;    /* next: address after a conditional branch at the end */
    const char *mark;           /* name of a function that controls the count, or NULL */
} block;

static struct { const char *name; cycles sum; } accounts[ACCOUNTS];
static int      account = -1;   /* account in use; -1: none */
static uint64_t after;          /* address after the last conditional branch; 0: none */

static void take_mark(const char *name)
{
    account = -1;
    if (strncmp(name, "count_as_", 9) != 0)
        return;
    for (account = 0; account < ACCOUNTS - 1 && accounts[account].name
                      && strcmp(accounts[account].name, name + 9) != 0;)
        account++;
    if (!accounts[account].name)
        accounts[account].name = name + 9;
}

static void execute(unsigned cpu, void *data)
{
    const block *b = data;
    const unsigned taken = after && after != b->start;

    (void)cpu;
    if (account >= 0) {
        cycles *sum = &accounts[account].sum;
        sum->instructions += b->own.instructions;
        sum->m0plus += b->own.m0plus + taken;
        sum->m0 += b->own.m0 + 2 * taken;
    }
    after = b->next;
    if (b->mark)
        take_mark(b->mark);
}

static void translate(plugin_id id, struct qemu_plugin_tb *translated)
{
    const size_t count = qemu_plugin_tb_n_insns(translated);
    block *b = calloc(1, sizeof *b);

    (void)id;
    if (!b)
        abort();
    for (size_t i = 0; i < count; i++) {
        struct qemu_plugin_insn *insn = qemu_plugin_tb_get_insn(translated, i);
        const uint64_t address = qemu_plugin_insn_vaddr(insn);
        const unsigned char *bytes = qemu_plugin_insn_data(insn);
        const unsigned half = bytes[0] | (unsigned)bytes[1] << 8;
        const cycles own = cycles_of(half);
        b->own.instructions += own.instructions;
        b->own.m0plus += own.m0plus;
        b->own.m0 += own.m0;
        b->start = i ? b->start : address;
        if (i + 1 == count && half >> 12 == 0xd && half >> 9 != 0xde00 >> 9)
            b->next = address + qemu_plugin_insn_size(insn);
    }
    const char *name = qemu_plugin_insn_symbol(qemu_plugin_tb_get_insn(translated, 0));
    if (name && strncmp(name, "count_", 6) == 0) {
        b->mark = strdup(name);
        b->own = (cycles){ 0, 0, 0 };
    }
    qemu_plugin_register_vcpu_tb_exec_cb(translated, execute, NO_REGISTERS, b);
}

static void report(plugin_id id, void *data)
{
    (void)id, (void)data;
    for (int i = 0; i < ACCOUNTS && accounts[i].name; i++)
        fprintf(stderr, "cycles %s %" PRIu64 " %" PRIu64 " %" PRIu64 "\n",
                accounts[i].name, accounts[i].sum.instructions, accounts[i].sum.m0plus,
                accounts[i].sum.m0);
}

EXPORT int qemu_plugin_install(plugin_id, const void *, int, char **);
int qemu_plugin_install(plugin_id id, const void *info, int argc, char **argv)
{
    (void)info, (void)argc, (void)argv;
    qemu_plugin_register_vcpu_tb_trans_cb(id, translate);
    qemu_plugin_register_atexit_cb(id, report, NULL);
    return 0;
}
