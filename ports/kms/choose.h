/* SPDX-License-Identifier: MIT */
/* Which monitor, mode and CRTC to show a picture on: judged by what the kernel says of
 * its connectors alone, so that it can be tested without any. */
#ifndef KMS_CHOOSE_H
#define KMS_CHOOSE_H
#include <stdbool.h>
#include <stdint.h>
#if __has_include(<drm/drm_mode.h>)     /* of the kernel, or where libdrm keeps them */
#include <drm/drm.h>
#include <drm/drm_mode.h>
#else
#include <libdrm/drm.h>
#include <libdrm/drm_mode.h>
#endif

#define KMS_MODES 256
#define KMS_OFF   UINT32_MAX            /* no CRTC */

enum { KMS_CONNECTED = 1, KMS_DISCONNECTED = 2, KMS_UNKNOWN = 3 };     /* the kernel's */

/* A connector as it was found. */
typedef struct {
    uint32_t connector;                 /* its id */
    uint32_t status;
    uint32_t crtcs;                     /* bit i: its encoders can take CRTC i */
    uint32_t busy;                      /* bit i: CRTC i drives some connector now */
    uint32_t crtc;                      /* that drives this one, or KMS_OFF */
    uint32_t n_modes;
    struct drm_mode_modeinfo modes[KMS_MODES];
} kms_head;

/* The better ones later: what the best connector lacks, if it lacks something. */
typedef enum { KMS_NOTHING, KMS_NO_MODE, KMS_NO_CRTC, KMS_SMALL, KMS_FITS } kms_verdict;

typedef struct {
    kms_verdict verdict;
    bool        sure, exact;            /* known to be connected; of the size wanted */
    uint32_t    connector, crtc;        /* id; index */
    struct drm_mode_modeinfo mode;
} kms_choice;

/* Takes `head` instead of the best one so far (at first all zeros) if it is better: one
 * that holds width x height (0: any) before others, connected for sure before perhaps, of
 * that very size before larger; else the first one stays.  Its mode is that size exactly,
 * else the preferred one, else the first that is large enough; its CRTC is the one that
 * drives it already, else a free one. */
void kms_offer(kms_choice *best, const kms_head *head, uint32_t width, uint32_t height);

/* The same timing, whatever its name and type. */
bool kms_has_mode(const kms_head *head, const struct drm_mode_modeinfo *mode);
#endif
