/* SPDX-License-Identifier: MIT */
/* Ranks connectors and their modes; the first of the highest rank wins. */
#include "mode_select.h"

static bool holds(const struct drm_mode_modeinfo *m, uint32_t width, uint32_t height)
{
    return m->hdisplay >= width && m->vdisplay >= height;
}

static bool is_exact(const struct drm_mode_modeinfo *m, uint32_t width, uint32_t height)
{
    return m->hdisplay == width && m->vdisplay == height;
}

static uint32_t mode_rank(const struct drm_mode_modeinfo *m, uint32_t width,
                          uint32_t height)
{
    return (holds(m, width, height) ? 8u : 0) | (is_exact(m, width, height) ? 4u : 0)
         | (m->type & DRM_MODE_TYPE_PREFERRED ? 2u : 0)
         | (m->flags & DRM_MODE_FLAG_INTERLACE ? 0 : 1u);
}

static const struct drm_mode_modeinfo *choose_mode(const kms_connector *head,
                                                   uint32_t width, uint32_t height)
{
    const struct drm_mode_modeinfo *best = &head->modes[0];
    for (uint32_t i = 1; i < head->n_modes; i++)
        if (mode_rank(&head->modes[i], width, height) > mode_rank(best, width, height))
            best = &head->modes[i];
    return best;
}

static uint32_t lowest(uint32_t bits)
{
    uint32_t i = 0;
    while (i < 32 && !(bits >> i & 1))
        i++;
    return i < 32 ? i : KMS_OFF;
}

static uint32_t choose_crtc(const kms_connector *head)
{
    if (head->crtc < 32 && head->crtcs >> head->crtc & 1)
        return head->crtc;
    uint32_t unused = head->crtcs & ~head->busy;
    return lowest(unused ? unused : head->crtcs);
}

static uint32_t rank(const kms_mode_choice *c)
{
    return (uint32_t)c->verdict << 2 | (c->sure ? 2u : 0) | (c->exact ? 1u : 0);
}

void kms_mode_offer(kms_mode_choice *best, const kms_connector *head, uint32_t width,
                    uint32_t height)
{
    if (head->status == KMS_DISCONNECTED)
        return;
    kms_mode_choice c = { .verdict = KMS_NO_MODE, .sure = head->status == KMS_CONNECTED,
                     .connector = head->connector, .crtc = choose_crtc(head) };
    if (head->n_modes > 0) {
        c.mode = *choose_mode(head, width, height);
        c.exact = is_exact(&c.mode, width, height);
        c.verdict = c.crtc == KMS_OFF                ? KMS_NO_CRTC
                  : !holds(&c.mode, width, height)   ? KMS_SMALL
                                                     : KMS_FITS;
    } else if (!c.sure) {
        return;         /* KMS_UNKNOWN without modes: treated as KMS_DISCONNECTED */
    }
    if (rank(&c) > rank(best))
        *best = c;
}

bool kms_connector_has_mode(const kms_connector *head, const struct drm_mode_modeinfo *mode)
{
    for (uint32_t i = 0; i < head->n_modes; i++) {
        const struct drm_mode_modeinfo *m = &head->modes[i];
        if (is_exact(m, mode->hdisplay, mode->vdisplay) && m->clock == mode->clock
            && m->htotal == mode->htotal && m->vtotal == mode->vtotal
            && m->flags == mode->flags)
            return true;
    }
    return false;
}
