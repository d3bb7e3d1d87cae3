/* SPDX-License-Identifier: MIT */
/* A graphics card that lies in memory, for what no emulated one does: ioctl, mmap,
 * munmap, socket, bind and clock_gettime of the test's program are its own.  Its device
 * is a pipe with a name, through which flips are reported. */
#ifndef TESTS_FAKE_KMS_H
#define TESTS_FAKE_KMS_H
#include <stdbool.h>
#include <stdint.h>
#include <stddef.h>
#include "../../ports/kms/choose.h"

#define FAKE_CONSOLE   90       /* the buffer that is shown before */
#define FAKE_CRTC      41       /* drives FAKE_CONNECTOR before; 40 is free */
#define FAKE_CONNECTOR 60       /* 61 is an empty socket */
#define FAKE_REFUSALS  3
#define FAKE_BUFFERS   8

typedef struct {
    uint32_t handle, fb, width, height, pitch, bits;
    uint8_t *memory;            /* of exactly its size */
    bool     mapped;
} fake_buffer;

typedef struct {
    /* What a test sets. */
    unsigned fail_call;         /* the n-th call fails with fail_errno; 0: none */
    int      fail_errno;
    struct { unsigned long request; int error; unsigned from; } refuse[FAKE_REFUSALS];
                                /* from the n-th time on; 0: always */
    bool     no_card, gone, taken, stalls, interrupts;
    bool     no_dumb, no_crtc, no_netlink;
    bool     other;             /* CRTC 40 drives something else */
    unsigned long no_wide;      /* the request that refuses 32 bits a pixel */
    uint32_t status, n_modes;
    struct drm_mode_modeinfo modes[4];
    int64_t  later_ms;          /* the clock is ahead */
    /* What it knows. */
    unsigned calls, probes, flips, sets, dirties, drawn_while_shown;
    bool     master, interrupted, flip_pending;
    uint64_t flip_number;
    fake_buffer buffers[FAKE_BUFFERS];
    uint32_t next;
    struct drm_mode_crtc crtc;  /* as it is now; fb_id 0: off */
    uint32_t connector;         /* shown on; 0: none */
    int      card, plug;        /* the pipe; where the kernel's news are written */
} fake_card;

extern fake_card fake;

void fake_reset(void);                          /* one monitor: 64x48, 48x32 preferred */
void fake_mode(int i, uint32_t width, uint32_t height, bool preferred);
void fake_new_card(void);                       /* after one that had gone */
void fake_vblank(void);                         /* a stalled flip is done */
void fake_report(uint64_t number);              /* of any flip */
void fake_uevent(const char *subsystem);
const fake_buffer *fake_shown(void);            /* NULL: not one of ours */
unsigned fake_left(void);                       /* buffers, names, mappings that exist */
#endif
