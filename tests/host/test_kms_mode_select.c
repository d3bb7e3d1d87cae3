/* SPDX-License-Identifier: MIT */
/* Choice of connector, mode and CRTC. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "../../ports/kms/mode_select.h"

enum { PREFERRED = 1, INTERLACED = 2 };

static void add(kms_connector *h, uint32_t width, uint32_t height, int what)
{
    struct drm_mode_modeinfo *m = &h->modes[h->n_modes++];
    *m = (struct drm_mode_modeinfo){ .hdisplay = (uint16_t)width,
                                     .vdisplay = (uint16_t)height, .clock = h->n_modes };
    m->type = what & PREFERRED ? DRM_MODE_TYPE_PREFERRED : DRM_MODE_TYPE_DRIVER;
    m->flags = what & INTERLACED ? DRM_MODE_FLAG_INTERLACE : 0;
}

/* A connected connector, 3 possible CRTCs, none assigned. */
static kms_connector *head_of(uint32_t id)
{
    kms_connector *h = test_calloc(1, sizeof *h);
    assert_non_null(h);
    h->connector = id;
    h->status = KMS_CONNECTED;
    h->crtcs = 7;
    h->crtc = KMS_OFF;
    return h;
}

static kms_mode_choice one(const kms_connector *h, uint32_t width, uint32_t height)
{
    kms_mode_choice c = { 0 };
    kms_mode_offer(&c, h, width, height);
    return c;
}

/* Returns the chosen mode by its order of adding; 0: none. */
static uint32_t mode_of(const kms_connector *h, uint32_t width, uint32_t height)
{
    kms_mode_choice c = one(h, width, height);
    return c.verdict == KMS_FITS ? c.mode.clock : 0;
}

static void the_size_wanted_then_the_preferred_then_the_first(void **state)
{
    (void)state;
    kms_connector *h = head_of(1);
    add(h, 800, 600, 0);
    add(h, 1024, 768, PREFERRED);
    add(h, 640, 480, INTERLACED);
    add(h, 640, 480, 0);
    add(h, 640, 480, 0);
    add(h, 1920, 1080, 0);
    assert_int_equal(mode_of(h, 0, 0), 2);
    assert_int_equal(mode_of(h, 640, 480), 4);          /* not the interlaced mode */
    assert_int_equal(mode_of(h, 1024, 768), 2);
    assert_int_equal(mode_of(h, 320, 240), 2);
    assert_int_equal(mode_of(h, 1100, 100), 6);         /* the only one large enough */
    assert_int_equal(mode_of(h, 641, 480), 2);
    h->modes[1].type = 0;
    assert_int_equal(mode_of(h, 0, 0), 1);
    assert_int_equal(mode_of(h, 700, 0), 1);
    h->modes[0].flags = DRM_MODE_FLAG_INTERLACE;
    assert_int_equal(mode_of(h, 700, 0), 2);
    test_free(h);
}

static void what_is_too_small_is_named(void **state)
{
    (void)state;
    kms_connector *h = head_of(1);
    add(h, 800, 600, 0);
    add(h, 1024, 768, PREFERRED);
    kms_mode_choice c = one(h, 1025, 700);
    assert_int_equal(c.verdict, KMS_SMALL);
    assert_int_equal(c.mode.hdisplay, 1024);
    assert_int_equal(one(h, 100, 769).verdict, KMS_SMALL);
    assert_int_equal(one(h, 1024, 768).verdict, KMS_FITS);
    test_free(h);
}

static void its_own_crtc_then_a_free_one_then_any(void **state)
{
    (void)state;
    kms_connector *h = head_of(1);
    add(h, 800, 600, 0);
    assert_int_equal(one(h, 0, 0).crtc, 0);
    h->busy = 3;
    assert_int_equal(one(h, 0, 0).crtc, 2);
    h->crtc = 1;
    assert_int_equal(one(h, 0, 0).crtc, 1);
    h->crtcs = 4 | 8;                   /* its encoders cannot use its current CRTC */
    assert_int_equal(one(h, 0, 0).crtc, 2);
    h->busy = 4 | 8;
    assert_int_equal(one(h, 0, 0).crtc, 2);
    h->busy = 4;
    assert_int_equal(one(h, 0, 0).crtc, 3);
    h->crtcs = h->busy = 1u << 31;
    assert_int_equal(one(h, 0, 0).crtc, 31);
    h->crtcs = 0;
    assert_int_equal(one(h, 0, 0).crtc, KMS_OFF);
    assert_int_equal(one(h, 0, 0).verdict, KMS_NO_CRTC);
    test_free(h);
}

static void nothing_is_had_of_what_is_not_connected(void **state)
{
    (void)state;
    kms_connector *h = head_of(1);
    assert_int_equal(one(h, 0, 0).verdict, KMS_NO_MODE);
    h->status = KMS_UNKNOWN;
    assert_int_equal(one(h, 0, 0).verdict, KMS_NOTHING);
    add(h, 800, 600, 0);
    assert_int_equal(one(h, 0, 0).verdict, KMS_FITS);
    h->status = KMS_DISCONNECTED;
    assert_int_equal(one(h, 0, 0).verdict, KMS_NOTHING);
    test_free(h);
}

/* Returns the better of two, offered in both orders; 0: none. */
static uint32_t better(const kms_connector *a, const kms_connector *b, uint32_t width)
{
    kms_mode_choice ab = { 0 }, ba = { 0 };
    kms_mode_offer(&ab, a, width, 0);
    kms_mode_offer(&ab, b, width, 0);
    kms_mode_offer(&ba, b, width, 0);
    kms_mode_offer(&ba, a, width, 0);
    assert_int_equal(ab.connector, ba.connector);
    return ab.connector;
}

static void the_best_connector_whatever_the_order(void **state)
{
    (void)state;
    kms_connector *a = head_of(1), *b = head_of(2);
    kms_mode_choice c = { 0 };
    add(a, 800, 600, 0);
    add(b, 640, 480, 0);
    kms_mode_offer(&c, a, 0, 0);
    kms_mode_offer(&c, b, 0, 0);
    assert_int_equal(c.connector, 1);           /* both fit: the first */
    assert_int_equal(better(a, b, 700), 1);     /* the other is too small */
    b->modes[0].hdisplay = 700;
    c = (kms_mode_choice){ 0 };
    kms_mode_offer(&c, a, 700, 480);
    kms_mode_offer(&c, b, 700, 480);
    assert_int_equal(c.connector, 2);           /* exact size */
    a->status = KMS_UNKNOWN;
    assert_int_equal(better(a, b, 0), 2);       /* surely connected */
    b->crtcs = 0;
    assert_int_equal(better(a, b, 0), 1);       /* but it has no CRTC */
    b->crtcs = 1;
    b->n_modes = 0;
    assert_int_equal(better(a, b, 0), 1);
    test_free(a);
    test_free(b);
}

static void a_mode_is_known_by_its_timing(void **state)
{
    (void)state;
    kms_connector *h = head_of(1);
    add(h, 800, 600, 0);
    add(h, 800, 600, PREFERRED);
    struct drm_mode_modeinfo m = h->modes[1];
    m.type = 0;
    memset(m.name, 'x', sizeof m.name);
    assert_true(kms_connector_has_mode(h, &m));
    m.clock++;
    assert_false(kms_connector_has_mode(h, &m));
    m.clock--;
    m.vdisplay--;
    assert_false(kms_connector_has_mode(h, &m));
    m.vdisplay++;
    m.htotal++;
    assert_false(kms_connector_has_mode(h, &m));
    test_free(h);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_size_wanted_then_the_preferred_then_the_first),
        cmocka_unit_test(what_is_too_small_is_named),
        cmocka_unit_test(its_own_crtc_then_a_free_one_then_any),
        cmocka_unit_test(nothing_is_had_of_what_is_not_connected),
        cmocka_unit_test(the_best_connector_whatever_the_order),
        cmocka_unit_test(a_mode_is_known_by_its_timing),
    };
    return cmocka_run_group_tests_name("kms choose", tests, NULL, NULL);
}
