/* SPDX-License-Identifier: MIT */
/* A QEMU plugin that counts the instructions of each function. The emulated program
 * controls the count by calling functions with these names, whose own instructions do not
 * count:
 *     count_as_NAME       count from now on to the account NAME
 *     count_end           stop counting
 *     count_section       close a section with the counts so far
 *
 * For each section, account and run of consecutive instructions the plugin prints a line
 *     count SECTION ACCOUNT FUNCTION INSTRUCTIONS ADDRESS
 *
 * The count is exact: a block that the emulator translates is executed as a whole, so each
 * execution adds the block's number of instructions to its functions' counters. Functions
 * come from the ELF's symbol table, so inlined code counts for its caller; the address, in
 * decimal, distinguishes functions with the same name. The file declares the part of QEMU's
 * plugin interface, version 1 (QEMU 4.2 to 8.2), that the plugin uses: Debian ships no
 * header. */
#include <inttypes.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* -- QEMU's interface ---------------------------------------------------------- */

#define EXPORT __attribute__((visibility("default")))

typedef uint64_t plugin_id;
struct qemu_plugin_tb;
struct qemu_plugin_insn;
enum { NO_REGISTERS = 0, INLINE_ADD = 0 };

typedef void insn_call(unsigned cpu, void *data);
typedef void translate_call(plugin_id, struct qemu_plugin_tb *);
typedef void exit_call(plugin_id, void *data);

void qemu_plugin_register_vcpu_tb_trans_cb(plugin_id, translate_call *);
void qemu_plugin_register_atexit_cb(plugin_id, exit_call *, void *data);
void qemu_plugin_register_vcpu_insn_exec_cb(struct qemu_plugin_insn *, insn_call *,
                                            int registers, void *data);
void qemu_plugin_register_vcpu_insn_exec_inline(struct qemu_plugin_insn *, int operation,
                                                void *counter, uint64_t add);
size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *);
struct qemu_plugin_insn *qemu_plugin_tb_get_insn(const struct qemu_plugin_tb *, size_t);
const char *qemu_plugin_insn_symbol(const struct qemu_plugin_insn *);
uint64_t qemu_plugin_insn_vaddr(const struct qemu_plugin_insn *);

EXPORT extern int qemu_plugin_version;
int qemu_plugin_version = 1;

/* -- counters ------------------------------------------------------------------ */

enum { ACCOUNTS = 8, CHAINS = 4096 };

/* Consecutive instructions within a block and a function. */
typedef struct run {
    const char *function;
    uint64_t address;                   /* address of the first instruction */
    uint64_t executed, before;          /* total executions; total when counting began */
    uint64_t counted[ACCOUNTS];
    struct run *next, *chained;
} run;

static run        *runs, *chains[CHAINS];
static const char *account_name[ACCOUNTS];
static int         account = -1;        /* account in use; -1: none */
static unsigned    section = 1;

static run *run_of(const char *function, uint64_t address)
{
    run **chain = &chains[address / 2 % CHAINS];
    run *r = *chain;
    while (r && r->address != address)
        r = r->chained;
    if (r)
        return r;
    r = calloc(1, sizeof *r);
    if (!r)
        abort();
    r->function = strdup(function);
    r->address = address;
    r->next = runs;
    r->chained = *chain;
    return *chain = runs = r;
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
    for (run *r = runs; r && account >= 0; r = r->next)
        r->counted[account] += r->executed - r->before;
    account = -1;
}

static void count_as(unsigned cpu, void *data)
{
    count_end(cpu, NULL);
    account = account_of(data);
    for (run *r = runs; r; r = r->next)
        r->before = r->executed;
}

static void count_section(unsigned cpu, void *data)
{
    count_end(cpu, data);
    for (run *r = runs; r; r = r->next) {
        for (int i = 0; i < ACCOUNTS; i++) {
            if (r->counted[i])
                fprintf(stderr, "count %u %s %s %" PRIu64 " %" PRIu64 "\n", section,
                        account_name[i], r->function, r->counted[i], r->address);
            r->counted[i] = 0;
        }
    }
    section++;
}

/* -- marks of the program ------------------------------------------------------ */

/* Callback for the first instruction of a mark; the mark's other instructions have none. */
static insn_call *mark_of(const char *name)
{
    return !strncmp(name, "count_as_", 9) ? count_as
         : !strcmp(name, "count_end") ? count_end
         : !strcmp(name, "count_section") ? count_section : NULL;
}

static const char *function_at(const struct qemu_plugin_tb *block, size_t i)
{
    const char *name = qemu_plugin_insn_symbol(qemu_plugin_tb_get_insn(block, i));
    return name ? name : "?";
}

static void translate(plugin_id id, struct qemu_plugin_tb *block)
{
    const size_t count = qemu_plugin_tb_n_insns(block);
    (void)id;
    for (size_t i = 0, end; i < count; i = end) {
        struct qemu_plugin_insn *insn = qemu_plugin_tb_get_insn(block, i);
        const char *function = function_at(block, i);
        for (end = i + 1; end < count && !strcmp(function, function_at(block, end));)
            end++;
        run *r = run_of(function, qemu_plugin_insn_vaddr(insn));
        insn_call *mark = mark_of(r->function);
        if (mark)
            qemu_plugin_register_vcpu_insn_exec_cb(insn, mark, NO_REGISTERS,
                                                   (void *)(uintptr_t)(r->function + 9));
        else
            qemu_plugin_register_vcpu_insn_exec_inline(insn, INLINE_ADD, &r->executed,
                                                       end - i);
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
    (void)info, (void)argc, (void)argv;
    qemu_plugin_register_vcpu_tb_trans_cb(id, translate);
    qemu_plugin_register_atexit_cb(id, report, NULL);
    return 0;
}
