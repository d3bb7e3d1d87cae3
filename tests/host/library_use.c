/* SPDX-License-Identifier: MIT */
/* Cases of library.sh for the host library, selected by name.
 *     library_use CASE SCENE [ARGUMENT] */
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <tidepool/host.h>
#include "tidepool/tidepool.h"

static tp_host_config small = { 160, 120, TP_FORMAT_XRGB8888, 0 };

static uint32_t crc_of(tp_host *host)
{
    const tp_host_picture *p = tp_host_draw(host);
    uint32_t crc = 0;

    for (uint32_t y = 0; y < p->height; y++)
        crc = tp_crc32_pixels(crc, p->format, (const char *)p->rows + y * p->stride,
                              (int)p->width);
    return crc;
}

static tp_host *opened(const char *path)
{
    tp_host_error err;
    tp_host *host = tp_host_open(path, &small, &err);

    if (!host) {
        printf("refused: %s\n", err.text);
        exit(1);
    }
    return host;
}

static void go(tp_host *host, int steps, const tp_input *input)
{
    for (int i = 0; i < steps; i++)
        tp_host_step(host, input);
}

/* Prints the CRCs of steps 0..ARGUMENT, as `tidepool render --hash` does. */
static void frames(tp_host *host, const char *last)
{
    for (int n = 0; n <= atoi(last); n++) {
        if (n > 0)
            tp_host_step(host, NULL);
        printf("frame %04d crc32 %08x\n", n, (unsigned)crc_of(host));
    }
}

/* The same frames by an engine of the caller's, from the loaded scene and assets. */
static void engine(tp_host *host, const char *last)
{
    const tp_config config = { .width = 160,
                               .height = 120,
                               .assets = tp_host_assets(host) };
    const size_t bytes = tp_engine_bytes(&config, tp_host_scene(host));
    void *memory = malloc(bytes);
    tp_engine *sea;
    tp_tile tile;

    if (tp_engine_init(&sea, &config, tp_host_scene(host), memory, bytes, NULL))
        exit(1);
    for (int n = 0; n <= atoi(last); n++, tp_engine_step(sea, NULL)) {
        uint32_t crc = 0;
        for (tp_engine_begin(sea); tp_engine_next_tile(sea, &tile);)
            crc = tp_crc32_pixels(crc, TP_FORMAT_XRGB8888, tile.pixels,
                                  (int)((tile.x1 - tile.x0) * (tile.y1 - tile.y0)));
        printf("frame %04d crc32 %08x\n", n, (unsigned)crc);
    }
    free(memory);
}

static bool is_near(tp_vec3 a, tp_vec3 b, tp_fx far)
{
    return abs(a.x - b.x) <= far && abs(a.y - b.y) <= far && abs(a.z - b.z) <= far;
}

static void looks(tp_host *host, const char *unused)
{
    static const char *const names[] = { "free", "orbit", "top", "boat" };
    const tp_input round = { .turn = TP_DEG(2) };
    tp_host_error err;

    (void)unused;
    const tp_vec3 eye = tp_world_camera(tp_host_world(host)).eye;
    for (int way = TP_HOST_WAYS - 1; way >= TP_HOST_FREE; way--) {
        if (!tp_host_look(host, (tp_host_way)way, &err)) {
            printf("%s: %s\n", names[way], err.text);
            continue;
        }
        printf("%s %08x", names[tp_host_get_way(host)], (unsigned)crc_of(host));
        for (int i = 0; i < 20; i++)
            tp_host_turn(host, &round);
        printf(" %08x\n", (unsigned)crc_of(host));
    }
    printf("the eye is %s\n",
           is_near(eye, tp_world_camera(tp_host_world(host)).eye, 4) ? "back" : "lost");
    printf("no way %d", tp_host_look(host, TP_HOST_WAYS, &err));
    printf(": %s\n", err.text);
}

/* Orbit keeps its target in the middle; an odd number of pixels has a middle pixel. */
static void orbit(tp_host *host, const char *unused)
{
    const int32_t x = (int32_t)small.width / 2, y = (int32_t)small.height / 2;
    const tp_input round = { .turn = TP_DEG(3) };
    tp_vec3 first, now;

    (void)unused;
    tp_host_look(host, TP_HOST_ORBIT, NULL);
    const tp_vec3 eye = tp_world_camera(tp_host_world(host)).eye;
    if (!tp_host_pick(host, x, y, &first))
        exit(1);
    for (int i = 0; i < 30; i++)
        tp_host_turn(host, &round);
    const bool stays = tp_host_pick(host, x, y, &now) && is_near(first, now, TP_FX(0.1));
    printf("%s, the eye %s\n", stays ? "stays" : "goes away",
           is_near(eye, tp_world_camera(tp_host_world(host)).eye, TP_FX(1))
               ? "too"
               : "goes round");
}

/* Returns the picture's CRC seven steps after pokes, a stir or nothing. */
static uint32_t acted(const char *path, bool poke, bool stir, int *took)
{
    tp_host *host = opened(path);
    const tp_scene_pool *pool = &tp_host_scene(host)->pool;

    *took = 0;
    go(host, 1, NULL);
    while (poke && *took < 1000 && tp_host_poke(host, pool->x, pool->z))
        ++*took;
    if (stir)
        *took = tp_host_stir(host, pool->x, pool->z);
    go(host, 6, NULL);
    const uint32_t crc = crc_of(host);
    tp_host_close(host);
    return crc;
}

static void pokes(tp_host *host, const char *path)
{
    int none, poked, stirred;
    const uint32_t still = acted(path, false, false, &none);
    const bool by_poke = acted(path, true, false, &poked) != still;
    const bool by_stir = acted(path, false, true, &stirred) != still;

    (void)host;
    printf("%d pokes: %s, %d stirs: %s\n", poked, by_poke ? "moved" : "still", stirred,
           by_stir ? "moved" : "still");
}

/* Returns the heading, degrees clockwise from -z. */
static int heading_of(tp_host *host)
{
    const tp_dir3 back = tp_world_camera(tp_host_world(host)).turn.z;

    return (int)((tp_atan2(-back.x, back.z) + TP_DEG(0.5)) / TP_DEG(1));
}

/* Each step takes its input once, for any number of ticks. */
static void turns(tp_host *host, const char *steps)
{
    const int heading = heading_of(host);

    go(host, atoi(steps), &(tp_input){ .turn = TP_DEG(2) });
    go(host, 8, &(tp_input){ .turn = 0 });      /* the camera is drawn a tick behind */
    printf("%d\n", (heading_of(host) - heading + 360) % 360 / 2);
}

static void list(const tp_host *host)
{
    tp_host_value value;

    for (uint32_t i = 0; tp_host_changed(host, i, &value); i++)
        printf("%u%s %s = %s\n", (unsigned)value.line, value.by_hand ? " hand" : "",
               value.name, value.value);
}

/* ARGUMENT: "name=value". */
static void set(tp_host *host, const char *setting)
{
    char name[128];
    tp_host_error err;
    const char *value = strchr(setting, '=') + 1;

    snprintf(name, sizeof name, "%.*s", (int)(value - setting - 1), setting);
    go(host, 5, NULL);
    const uint32_t before = crc_of(host);
    const bool done = tp_host_set(host, name, value, &err);
    printf("%s, %s picture: %s\n", done ? "set" : "refused",
           crc_of(host) == before ? "the same" : "another", err.text);
    list(host);
}

static void values(tp_host *host, const char *name)
{
    tp_host_value value;

    list(host);
    if (tp_host_get(host, name, &value))
        printf("it is %s, line %u\n", value.value, (unsigned)value.line);
    else
        printf("%s is none\n", name);
}

/* camera.follow set while on the deck takes effect when the camera is free again. */
static void follow(tp_host *host, const char *word)
{
    tp_host_value value;

    tp_host_look(host, TP_HOST_BOAT, NULL);
    const uint32_t deck = crc_of(host);
    printf("%d", tp_host_set(host, "camera.follow", word, NULL));
    printf(" %s", crc_of(host) == deck ? "the same" : "another");
    tp_host_look(host, TP_HOST_FREE, NULL);
    tp_host_get(host, "camera.follow", &value);
    printf(", free: %s\n", value.value);
}

/* A picture ARGUMENT px wide. */
static void sized(const char *path, const char *width)
{
    const tp_host_config config = { .width = (uint32_t)atoi(width), .height = 120 };
    tp_host_error err;
    tp_host *host = tp_host_open(path, &config, &err);

    printf("%s: %s\n", host ? "opened" : "refused", err.text);
    if (!host && tp_host_open(path, &config, NULL))
        exit(1);
    tp_host_close(host);
}

static void save(tp_host *host, const char *path)
{
    tp_host_error err;

    printf("%d", tp_host_save_png(host, path, &err));
    printf(": %s\n", err.text);
}

/* -- two scenes ------------------------------------------------------------------------ */

static void *run(void *path)
{
    tp_host *host = opened(path);
    tp_host_error err;
    char *text = malloc(32);

    for (int i = 0; i < 20; i++)
        tp_host_step(host, NULL);
    for (int i = 0; i < 1000; i++)
        if (tp_host_set(host, "no.such", "1", &err) || !strstr(err.text, "no.such"))
            exit(1);
    snprintf(text, 32, "%08x", (unsigned)crc_of(host));
    tp_host_close(host);
    return text;
}

/* Two hosts one after the other, alternating, and in two threads at once draw the same
 * pictures. */
static void two(const char *a, const char *b)
{
    char *const alone[2] = { run((void *)a), run((void *)b) };
    tp_host *host[2] = { opened(a), opened(b) };
    pthread_t thread[2];
    bool same = true;

    for (int i = 0; i < 20; i++)
        for (int k = 0; k < 2; k++)
            tp_host_step(host[k], NULL);
    pthread_create(&thread[0], NULL, run, (void *)a);
    pthread_create(&thread[1], NULL, run, (void *)b);
    for (int k = 0; k < 2; k++) {
        char in_turns[32];
        void *at_once;
        snprintf(in_turns, sizeof in_turns, "%08x", (unsigned)crc_of(host[k]));
        pthread_join(thread[k], &at_once);
        same = same && !strcmp(alone[k], in_turns) && !strcmp(alone[k], at_once);
        free(at_once);
        tp_host_close(host[k]);
    }
    printf("%s, %s scenes\n", same ? "the same" : "other pictures",
           strcmp(alone[0], alone[1]) ? "two" : "one");
    free(alone[0]);
    free(alone[1]);
}

int main(int argc, char **argv)
{
    static const struct {
        const char *name;
        void (*run)(tp_host *host, const char *argument);
    } cases[] = {
        { "frames", frames }, { "engine", engine }, { "looks", looks },
        { "orbit", orbit },   { "pokes", pokes },   { "set", set },
        { "values", values }, { "save", save },     { "follow", follow },
        { "turns", turns },
    };
    if (argc < 4)
        return 2;
    if (strcmp(argv[1], "orbit") == 0)
        small.width = 159, small.height = 119;
    if (strcmp(argv[1], "sized") == 0)
        sized(argv[2], argv[3]);
    if (strcmp(argv[1], "two") == 0)
        two(argv[2], argv[3]);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        if (strcmp(argv[1], cases[i].name) == 0) {
            tp_host *host = opened(argv[2]);
            cases[i].run(host, argv[3]);
            tp_host_close(host);
        }
    }
    return 0;
}
