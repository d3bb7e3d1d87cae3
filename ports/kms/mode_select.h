/* SPDX-License-Identifier: MIT */
/* Choice of monitor, mode and CRTC for a picture.  Pure functions of the connector data,
 * to be tested without hardware. */
#ifndef TP_KMS_MODE_SELECT_H
#define TP_KMS_MODE_SELECT_H
#include <stdbool.h>
#include <stdint.h>
#if __has_include(<drm/drm_mode.h>)     /* kernel headers, or libdrm's copies */
#include <drm/drm.h>
#include <drm/drm_mode.h>
#else
#include <libdrm/drm.h>
#include <libdrm/drm_mode.h>
#endif

#define KMS_MODES 256
#define KMS_OFF   UINT32_MAX            /* no CRTC */

enum { KMS_CONNECTED = 1, KMS_DISCONNECTED = 2, KMS_UNKNOWN = 3 };     /* kernel's values */

/* A connector and its state. */
typedef struct {
    uint32_t connector;                 /* its id */
    uint32_t status;
    uint32_t crtcs;                     /* bit i: usable with CRTC i */
    uint32_t busy;                      /* bit i: CRTC i drives some connector now */
    uint32_t crtc;                      /* index of its current CRTC, or KMS_OFF */
    uint32_t n_modes;
    struct drm_mode_modeinfo modes[KMS_MODES];
} kms_connector;

/* Result, from worst to best; names the fault of the best connector. */
typedef enum {
    KMS_NOTHING,
    KMS_NO_MODE,
    KMS_NO_CRTC,
    KMS_SMALL,
    KMS_FITS
} kms_mode_verdict;

typedef struct {
    kms_mode_verdict verdict;
    bool        sure, exact;            /* surely connected; exactly the wanted size */
    uint32_t    connector, crtc;        /* connector: id; crtc: index */
    struct drm_mode_modeinfo mode;
} kms_mode_choice;

/* Replaces the best connector so far (at first all zeros) by `head`, if `head` is
 * better.  Order: mode of at least width x height (0: any) first, then surely connected,
 * then exactly the wanted size; on a tie the earlier one stays.  The mode is the exact
 * size, else the preferred one, else the first large enough; the CRTC is the connector's
 * current one, else a free one. */
void kms_mode_offer(kms_mode_choice *best, const kms_connector *head, uint32_t width,
                    uint32_t height);

/* True if the connector has a mode of the same timing; name and type are ignored. */
bool kms_connector_has_mode(const kms_connector *head,
                            const struct drm_mode_modeinfo *mode);
#endif
