/* SPDX-License-Identifier: MIT */
/* Plugin of QEMU's user mode: at each getppid() of the program the plugin prints the exact
 * number of instructions executed, as "insns N" on stderr.
 *
 *   qemu-x86_64 -plugin tally.so,call=110 PROGRAM      (the number of getppid)
 *
 * The file declares the part of QEMU's plugin interface, version 1 (QEMU 4.2 to 8.2), that
 * the plugin uses: Debian ships no header. */
#include <inttypes.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define EXPORT __attribute__((visibility("default")))

typedef uint64_t plugin_id;
struct qemu_plugin_tb;
enum { INLINE_ADD = 0 };

typedef void translate_call(plugin_id, struct qemu_plugin_tb *);
typedef void syscall_call(plugin_id, unsigned cpu, int64_t number, uint64_t a1,
                          uint64_t a2, uint64_t a3, uint64_t a4, uint64_t a5,
                          uint64_t a6, uint64_t a7, uint64_t a8);

void qemu_plugin_register_vcpu_tb_trans_cb(plugin_id, translate_call *);
void qemu_plugin_register_vcpu_syscall_cb(plugin_id, syscall_call *);
void qemu_plugin_register_vcpu_tb_exec_inline(struct qemu_plugin_tb *, int operation,
                                              void *counter, uint64_t add);
size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *);

EXPORT extern int qemu_plugin_version;
int qemu_plugin_version = 1;

static uint64_t executed;
static int64_t  mark = -1;

static void translate(plugin_id id, struct qemu_plugin_tb *block)
{
    (void)id;
    qemu_plugin_register_vcpu_tb_exec_inline(block, INLINE_ADD, &executed,
                                             qemu_plugin_tb_n_insns(block));
}

static void on_call(plugin_id id, unsigned cpu, int64_t number, uint64_t a1, uint64_t a2,
                    uint64_t a3, uint64_t a4, uint64_t a5, uint64_t a6, uint64_t a7,
                    uint64_t a8)
{
    (void)id, (void)cpu, (void)a1, (void)a2, (void)a3, (void)a4, (void)a5, (void)a6;
    (void)a7, (void)a8;
    if (number == mark)
        fprintf(stderr, "insns %" PRIu64 "\n", executed);
}

EXPORT int qemu_plugin_install(plugin_id, const void *, int, char **);
int qemu_plugin_install(plugin_id id, const void *info, int argc, char **argv)
{
    (void)info;
    for (int i = 0; i < argc; i++)
        if (!strncmp(argv[i], "call=", 5))
            mark = atoll(argv[i] + 5);
    qemu_plugin_register_vcpu_tb_trans_cb(id, translate);
    qemu_plugin_register_vcpu_syscall_cb(id, on_call);
    return 0;
}
