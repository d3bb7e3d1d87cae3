/* SPDX-License-Identifier: MIT */
/* Tidepool on machines with files: scenes are loaded by path, with all that they name,
 * looked at in the preview's ways, and saved as PNG.
 *
 *     tp_host_error err;
 *     tp_host *host = tp_host_open("harbour.ini", NULL, &err);
 *
 *     if (!host)
 *         return fprintf(stderr, "%s\n", err.text), 1;
 *     tp_host_look(host, TP_HOST_ORBIT, NULL);
 *     for (int i = 0; i < 60; i++)
 *         tp_host_step(host, &(tp_input){ .turn = TP_DEG(1) });
 *     tp_host_save_png(host, "harbour.png", NULL);
 *     tp_host_close(host);
 *
 * The library is libtidepool-host.a (pkg-config tidepool-host).  It takes memory by malloc,
 * writes nothing on standard streams, ends no program and catches no signal.  No pointer
 * may be NULL but those that are said to.  What it draws it draws by the whole of Tidepool,
 * not by a baked program.
 *
 * Threads: a tp_host is for one thread at a time.  Several of them know nothing of each
 * other and may be used by several threads at once.  One thing they share: names of files
 * longer than a scene holds (TP_NAME_BYTES) are kept, once each, until the program ends. */
#ifndef TP_HOST_H
#define TP_HOST_H
#include "tidepool/tidepool.h"

TP_BEGIN_C

/* A scene that was loaded, the water that moves in it, and a picture of it. */
typedef struct tp_host tp_host;

/* What went wrong, in lines parted by '\n' and without one at the end; what a person gave
 * comes first: "harbour.ini:14: boat.scale = 0 is outside 0.001..1000".  Longer text is
 * cut.  After a success it holds warnings, or "".  Every tp_host_error * may be NULL. */
typedef struct {
    char text[2048];
} tp_host_error;

/* All 0 is the default. */
typedef struct {
    uint32_t width, height; /* of the picture, pixels, 16..4096; both 0: 640x480 */
    tp_format format;       /* 0: xrgb8888 */
    uint32_t threads;       /* that draw, 64 at the most; 0: the caller's alone */
} tp_host_config;

/* A picture: row y begins at rows + y stride, its pixels as the format has them. */
typedef struct {
    tp_format format;
    uint32_t width, height; /* pixels */
    size_t stride;          /* bytes */
    const void *rows;
} tp_host_picture;

/* -- a scene ---------------------------------------------------------------------------- */

/* Loads the scene file (INI) of this path with the OBJ, PNGs and maps that it names, which
 * lie by paths relative to it; the water is at tick 0, the camera where the scene has it.
 * The config (NULL: all 0) is copied.  NULL: the file, or one that it names, is missing,
 * cannot be read or is refused, a size is out of range, or memory is lacking; *err tells
 * the file and the line. */
tp_host *tp_host_open(const char *path, const tp_host_config *config, tp_host_error *err);

/* Frees it and all that its functions returned; NULL: does nothing. */
void tp_host_close(tp_host *host);

/* What was read: the scene, and the meshes, pictures and maps that it names.  Both stand
 * where they are until tp_host_close, and change by tp_host_set and tp_host_look alone.
 * Engines of the application's own may be made of them; after a change such an engine wants
 * tp_engine_apply, and after one of a file's name tp_engine_init, before it is used. */
const tp_scene *tp_host_scene(const tp_host *host);
const tp_assets *tp_host_assets(const tp_host *host);

/* A value by the name that scene files and `tidepool params` have, as text:
 * "wave0.steepness", "0.4".  The names of files are relative to the current folder or, if
 * there is no such file, to the scene's.  What it needs is done: pictures are loaded, the
 * world goes on with it, or is made anew at the same place and time (then pools, drops and
 * foam begin anew, and worlds had before are gone).  False: refused, *err tells, and all
 * is as it was. */
bool tp_host_set(tp_host *host, const char *name, const char *value, tp_host_error *err);

/* A parameter of the scene as text of less than TP_NAME_BYTES. */
typedef struct {
    const char *name; /* "wave0.steepness"; stands for ever */
    char value[TP_NAME_BYTES];
    uint32_t line; /* of the scene file that set it; 0: the default */
    bool by_hand;  /* tp_host_set did */
} tp_host_value;

/* The value of a name; false: no parameter is called so, and nothing is written. */
bool tp_host_get(const tp_host *host, const char *name, tp_host_value *value);

/* The i-th value, from 0, that the file or tp_host_set has set, in the order of the table
 * of parameters; false: there are not so many. */
bool tp_host_changed(const tp_host *host, uint32_t i, tp_host_value *value);

/* -- the water ------------------------------------------------------------------------- */

/* The world of the scene, for the core's tp_world_ functions; until the next tp_host_set,
 * tp_host_look or tp_host_close. */
tp_world *tp_host_world(tp_host *host);

/* Moves water and camera on by 1/60 s, times the scene's clock.scale.  The input is bent by
 * the way to look; pokes that wait are added to it.  NULL: nobody acts.  In slow motion a
 * step may be without a tick of the world; the input then moves the camera alone, and the
 * rest of it is lost. */
void tp_host_step(tp_host *host, const tp_input *input);

/* The same of the camera alone, while the water stands. */
void tp_host_turn(tp_host *host, const tp_input *input);

/* A poke at (x, z), m of the world, of the scene's pool: a hat as high and wide as the
 * scene's own pokes.  It acts in one of the next steps; 64 may wait.  False: the scene has
 * no pool, or too many wait. */
bool tp_host_poke(tp_host *host, tp_fx x, tp_fx z);

/* One place farther on the path of a finger or a mouse through the pool: the path of one
 * step puts a third of a poke into it, wherever it leads.  False: the scene has no pool. */
bool tp_host_stir(tp_host *host, tp_fx x, tp_fx z);

/* -- the ways to look ------------------------------------------------------------------ */

typedef enum {
    TP_HOST_FREE,  /* input moves the camera; where it was when it was last free */
    TP_HOST_ORBIT, /* round what the middle of the picture shows: the boat, with which the
                     * camera then goes, the water, or a place ahead.  Input: turn, tilt and
                     * aside go round, ahead comes nearer, up rises */
    TP_HOST_TOP,  /* from above it: ahead and aside glide, up rises, turn turns the map */
    TP_HOST_BOAT, /* on the deck, as free as TP_HOST_FREE */
    TP_HOST_WAYS
} tp_host_way;

/* The camera looks this way from now on, and is there at once.  The way that is on already
 * begins anew.  It sets the scene's camera.follow.  False: the scene has no boat to stand
 * on, there is no such way, or memory is lacking; nothing has changed, and *err tells. */
bool tp_host_look(tp_host *host, tp_host_way way, tp_host_error *err);
tp_host_way tp_host_way_of(const tp_host *host);

/* -- pictures -------------------------------------------------------------------------- */

/* Draws the world as it is now.  The picture stands until the next tp_host_draw,
 * tp_host_save_png, tp_host_set, tp_host_look or tp_host_close.  NULL: an earlier change
 * left no memory for it. */
const tp_host_picture *tp_host_draw(tp_host *host);

/* Draws, and writes that to a PNG of exactly the shown colours.  The file replaces the one
 * of its name when it is whole; a device, a pipe and the like is written as it is.
 * False: it could not be written, *err tells, and the old file stands. */
bool tp_host_save_png(tp_host *host, const char *path, tp_host_error *err);

/* The place on the water under pixel (x, y) of the picture, from its upper left corner, as
 * the last tick left it: within 1 px of what is drawn there.  False: there is none within
 * 8000 m, or land or a tank's wall stands before it. */
bool tp_host_pick(const tp_host *host, int32_t x, int32_t y, tp_vec3 *at);

TP_END_C
#endif
