/* SPDX-License-Identifier: MIT */
/* A graphics card in memory, for faults of no emulated card.  Replaces ioctl, mmap,
 * munmap, socket, bind and clock_gettime of the test program.  Its device is a named
 * pipe; flip events come through the pipe. */
#ifndef TP_TESTS_HOST_FAKE_KMS_H
#define TP_TESTS_HOST_FAKE_KMS_H
#include <stdbool.h>
#include <stdint.h>
#include <stddef.h>
#include "../../ports/kms/mode_select.h"

#define FAKE_CONSOLE   90       /* buffer shown before the start */
#define FAKE_CRTC      41       /* drives FAKE_CONNECTOR before the start; 40 is free */
#define FAKE_CONNECTOR 60       /* 61 is not connected */
#define FAKE_REFUSALS  3
#define FAKE_BUFFERS   8

typedef struct {
    uint32_t handle, fb, width, height, pitch, bits;
    uint8_t *memory;            /* allocated to the byte */
    bool     mapped;
} fake_buffer;

typedef struct {
    /* Set by a test: */
    unsigned fail_call;         /* call number to fail with fail_errno; 0: none */
    int      fail_errno;
    struct { unsigned long request; int error; unsigned from; } refuse[FAKE_REFUSALS];
                                /* from the n-th time on; 0: always */
    bool     no_card, gone, taken, stalls, interrupts;
    bool     no_dumb, no_crtc, no_netlink;
    bool     other;             /* CRTC 40 drives another connector */
    unsigned long no_wide;      /* request to fail for 32 bits per pixel */
    uint32_t status, n_modes;
    struct drm_mode_modeinfo modes[4];
    int64_t  later_ms;          /* the clock is ahead, ms */
    /* State of the card: */
    unsigned calls, probes, flips, sets, dirties, drawn_while_shown;
    bool     master, interrupted, flip_pending;
    uint64_t flip_number;
    fake_buffer buffers[FAKE_BUFFERS];
    uint32_t next;
    struct drm_mode_crtc crtc;  /* current state; fb_id 0: off */
    uint32_t connector;         /* current connector; 0: none */
    int      card, plug;        /* the pipe; sends the kernel's hotplug events */
} fake_card;

extern fake_card fake;

void fake_reset(void);                          /* one monitor: 64x48, preferred 48x32 */
void fake_mode(int i, uint32_t width, uint32_t height, bool preferred);
void fake_new_card(void);                       /* replaces an unplugged card */
void fake_vblank(void);                         /* completes a stalled flip */
void fake_report(uint64_t number);              /* reports a flip of any number */
void fake_uevent(const char *subsystem);
const fake_buffer *fake_shown(void);            /* NULL: not a buffer of ours */
unsigned fake_left(void);                       /* existing buffers, ids and mappings */
#endif
