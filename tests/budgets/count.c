/* SPDX-License-Identifier: MIT */
/* A QEMU plugin that counts: instructions, loads and stores of each function, and the
 * deepest stack.  The emulated program says what is counted by calling functions of
 * these names, whose own instructions are not:
 *     count_as_NAME       from now on, on the account NAME
 *     count_end           no more
 *     count_section       what was counted so far is a section of its own
 *
 *   qemu-system-arm ... -plugin count.so,low=ADDRESS,high=ADDRESS      (of the stack)
 *
 * Counting is exact: an emulated instruction is counted when it executes, by a counter of
 * the function it lies in.  Functions are those of the ELF's symbol table, so what was
 * inlined counts for its caller.  Declares what it uses of QEMU's plugin interface,
 * version 1 (QEMU 4.2 to 8.2), since Debian ships no header of it. */
#include <inttypes.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* -- QEMU's side --------------------------------------------------------------- */

#define EXPORT __attribute__((visibility("default")))

typedef uint64_t plugin_id;
struct qemu_plugin_tb;
struct qemu_plugin_insn;
enum { NO_REGISTERS = 0, INLINE_ADD = 0, MEMORY_READ = 1, MEMORY_WRITE = 2 };

typedef void insn_call(unsigned cpu, void *data);
typedef void memory_call(unsigned cpu, uint32_t info, uint64_t address, void *data);
typedef void translate_call(plugin_id, struct qemu_plugin_tb *);
typedef void exit_call(plugin_id, void *data);

void qemu_plugin_register_vcpu_tb_trans_cb(plugin_id, translate_call *);
void qemu_plugin_register_atexit_cb(plugin_id, exit_call *, void *data);
void qemu_plugin_register_vcpu_insn_exec_cb(struct qemu_plugin_insn *, insn_call *,
                                            int registers, void *data);
void qemu_plugin_register_vcpu_insn_exec_inline(struct qemu_plugin_insn *, int operation,
                                                void *counter, uint64_t add);
void qemu_plugin_register_vcpu_mem_cb(struct qemu_plugin_insn *, memory_call *,
                                      int registers, int reads_or_writes, void *data);
size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *);
struct qemu_plugin_insn *qemu_plugin_tb_get_insn(const struct qemu_plugin_tb *, size_t);
const char *qemu_plugin_insn_symbol(const struct qemu_plugin_insn *);
bool qemu_plugin_mem_is_store(uint32_t info);

EXPORT extern int qemu_plugin_version;
int qemu_plugin_version = 1;

/* -- counters ------------------------------------------------------------------ */

enum { ACCOUNTS = 8 };

typedef struct {
    uint64_t insns, loads, stores;
} sums;

typedef struct function {
    const char *name;
    uint64_t executed, before;          /* instructions: ever, and when counting began */
    sums     counted[ACCOUNTS];
    struct function *next;
} function;

static function   *functions;
static const char *account_name[ACCOUNTS];
static int         account = -1;        /* that is counted on; -1: none */
static unsigned    section = 1;
static uint64_t    stack_low, stack_high, deepest = UINT64_MAX;

static function *function_of(const char *name)
{
    function *f = functions;
    while (f && strcmp(f->name, name))
        f = f->next;
    if (!f) {
        f = calloc(1, sizeof *f);
        if (!f)
            abort();
        f->name = strdup(name);
        f->next = functions;
        functions = f;
    }
    return f;
}

static int account_of(const char *name)
{
    int i = 0;
    while (i < ACCOUNTS - 1 && account_name[i] && strcmp(account_name[i], name))
        i++;
    if (!account_name[i])
        account_name[i] = strdup(name);
    return i;
}

static void count_end(unsigned cpu, void *data)
{
    (void)cpu, (void)data;
    for (function *f = functions; f && account >= 0; f = f->next)
        f->counted[account].insns += f->executed - f->before;
    account = -1;
}

static void count_as(unsigned cpu, void *data)
{
    count_end(cpu, NULL);
    account = account_of(data);
    for (function *f = functions; f; f = f->next)
        f->before = f->executed;
}

static void touch(unsigned cpu, uint32_t info, uint64_t address, void *data)
{
    function *f = data;
    (void)cpu;
    if (account < 0)
        return;
    if (!qemu_plugin_mem_is_store(info)) {
        f->counted[account].loads++;
        return;
    }
    f->counted[account].stores++;
    if (address >= stack_low && address < stack_high && address < deepest)
        deepest = address;
}

/* A line for each account and function that it holds, for a script to sort. */
static void count_section(unsigned cpu, void *data)
{
    count_end(cpu, data);
    for (function *f = functions; f; f = f->next) {
        for (int i = 0; i < ACCOUNTS; i++) {
            sums *c = &f->counted[i];
            if (c->insns)
                fprintf(stderr, "count %u %s %s %" PRIu64 " %" PRIu64 " %" PRIu64 "\n",
                        section, account_name[i], f->name, c->insns, c->loads, c->stores);
            *c = (sums){ 0 };
        }
    }
    if (deepest < stack_high)
        fprintf(stderr, "stack %u %" PRIu64 "\n", section, stack_high - deepest);
    deepest = UINT64_MAX;
    section++;
}

/* -- watching the program ------------------------------------------------------ */

/* What to do at a mark's first instruction; the others of it do nothing. */
static insn_call *mark_of(const char *name)
{
    return !strncmp(name, "count_as_", 9) ? count_as
         : !strcmp(name, "count_end") ? count_end
         : !strcmp(name, "count_section") ? count_section : NULL;
}

static void translate(plugin_id id, struct qemu_plugin_tb *block)
{
    const char *within = "";
    (void)id;
    for (size_t i = 0; i < qemu_plugin_tb_n_insns(block); i++) {
        struct qemu_plugin_insn *insn = qemu_plugin_tb_get_insn(block, i);
        const char *name = qemu_plugin_insn_symbol(insn);
        function *f = function_of(name ? name : "?");
        insn_call *mark = mark_of(f->name);
        if (mark && strcmp(f->name, within))
            qemu_plugin_register_vcpu_insn_exec_cb(insn, mark, NO_REGISTERS,
                                                   (void *)(uintptr_t)(f->name + 9));
        if (!mark) {
            qemu_plugin_register_vcpu_insn_exec_inline(insn, INLINE_ADD, &f->executed, 1);
            qemu_plugin_register_vcpu_mem_cb(insn, touch, NO_REGISTERS,
                                             MEMORY_READ | MEMORY_WRITE, f);
        }
        within = f->name;
    }
}

static void report(plugin_id id, void *data)
{
    (void)id;
    count_section(0, data);
}

EXPORT int qemu_plugin_install(plugin_id, const void *, int, char **);
int qemu_plugin_install(plugin_id id, const void *info, int argc, char **argv)
{
    (void)info;
    for (int i = 0; i < argc; i++) {
        if (!strncmp(argv[i], "low=", 4))
            stack_low = strtoull(argv[i] + 4, NULL, 0);
        else if (!strncmp(argv[i], "high=", 5))
            stack_high = strtoull(argv[i] + 5, NULL, 0);
    }
    qemu_plugin_register_vcpu_tb_trans_cb(id, translate);
    qemu_plugin_register_atexit_cb(id, report, NULL);
    return 0;
}
