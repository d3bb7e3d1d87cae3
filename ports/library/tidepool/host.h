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
 * The library is libtidepool-host.a (pkg-config tidepool-host).  It allocates by malloc,
 * never writes to standard streams, never ends the program and catches no signal.  A
 * pointer may be NULL only where its function says so.  It draws with the whole of
 * Tidepool, not with a baked program.
 *
 * Threads: one thread at a time may use a tp_host; different ones may be used by different
 * threads at once.  They share one thing: file names longer than a scene holds
 * (TP_NAME_BYTES) are kept, once each, until the program ends. */
#ifndef TP_HOST_H
#define TP_HOST_H
#include "tidepool/tidepool.h"

TP_BEGIN_C

/* A scene that was loaded, the water that moves in it, and a picture of it. */
typedef struct tp_host tp_host;

/* An error as text: lines with '\n' between them, each with its file and line first,
 * "harbour.ini:14: boat.scale = 0 is outside 0.001..1000".  Longer text is cut.  After a
 * success it holds warnings, or "".  Every tp_host_error * may be NULL. */
typedef struct {
    char text[2048];
} tp_host_error;

/* All 0 is the default. */
typedef struct {
    uint32_t width, height; /* of the picture, pixels, 16..4096; both 0: 640x480 */
    tp_format format;       /* 0: xrgb8888 */
    uint32_t threads;       /* drawing threads, the caller's included, 1..64; 0: as 1 */
} tp_host_config;

/* A picture: row y begins at rows + y stride. */
typedef struct {
    tp_format format;
    uint32_t width, height; /* pixels */
    size_t stride;          /* bytes */
    const void *rows;
} tp_host_picture;

/* -- a scene ------------------------------------------------------------------------- */

/* Loads a scene file (INI) and the OBJ, PNGs and maps that it names, by paths relative
 * to the scene file.  The water is at tick 0.  The config is copied; NULL means all 0.
 * Returns NULL if a file is missing or refused, a size is out of range or memory is
 * short; *err names the file and the line. */
tp_host *tp_host_open(const char *path, const tp_host_config *config, tp_host_error *err);

/* Frees the host and all that its functions returned.  NULL: does nothing. */
void tp_host_close(tp_host *host);

/* The loaded scene, and the meshes, pictures and maps that it names.  Both stay in
 * place until tp_host_close; only tp_host_set and tp_host_look change them.  An
 * application may make engines of its own from them; after a change call
 * tp_engine_apply, after the change of a file's name tp_engine_init. */
const tp_scene *tp_host_scene(const tp_host *host);
const tp_assets *tp_host_assets(const tp_host *host);

/* Sets a parameter by its name in scene files, from text: "wave0.steepness", "0.4".  A file
 * name is relative to the current folder or, if no such file is there, to the scene's.  The
 * host loads new pictures and applies the change.  If the world needs another layout, the
 * host makes it again at the same place and time: pools, drops and foam start again, and
 * pointers of tp_host_world end.  False: refused, *err says why, nothing has changed. */
bool tp_host_set(tp_host *host, const char *name, const char *value, tp_host_error *err);

/* A parameter of the scene as text of less than TP_NAME_BYTES. */
typedef struct {
    const char *name; /* "wave0.steepness"; stays for ever */
    char value[TP_NAME_BYTES];
    uint32_t line; /* of the scene file that set it; 0: the default */
    bool by_hand;  /* tp_host_set set it */
} tp_host_value;

/* Reads a parameter by its name.  False: no parameter has this name; *value is
 * unchanged. */
bool tp_host_get(const tp_host *host, const char *name, tp_host_value *value);

/* The i-th parameter, from 0, that the file or tp_host_set set, in the order of the
 * table of parameters.  False: there are no more. */
bool tp_host_changed(const tp_host *host, uint32_t i, tp_host_value *value);

/* -- the water ----------------------------------------------------------------------- */

/* The world, for the functions of tidepool/world.h.  The pointer is valid until the next
 * tp_host_set, tp_host_look or tp_host_close. */
tp_world *tp_host_world(tp_host *host);

/* Moves water and camera on by 1/60 s times the scene's clock.scale.  The camera mode
 * turns the input into the camera's motion; waiting pokes are added.  NULL: no input.
 * In slow motion some steps have no tick of the world: input then moves only the
 * camera, and the rest of the input is lost. */
void tp_host_step(tp_host *host, const tp_input *input);

/* Moves only the camera, while the water stands still. */
void tp_host_turn(tp_host *host, const tp_input *input);

/* Pokes the scene's pool at (x, z), m: a splash as high and wide as the scene's own
 * pokes.  It acts in one of the next steps.  False: the scene has no pool, or 64 pokes
 * wait already. */
bool tp_host_poke(tp_host *host, tp_fx x, tp_fx z);

/* Drags a finger through the pool to (x, z), m: the path of one step makes a third of
 * a poke along the way.  False: the scene has no pool. */
bool tp_host_stir(tp_host *host, tp_fx x, tp_fx z);

/* -- camera modes -------------------------------------------------------------------- */

typedef enum {
    TP_HOST_FREE,   /* input moves the camera, from where it was free last */
    TP_HOST_ORBIT,  /* around the object in the middle of the picture: the boat, which the
                     * camera then follows, the water, or a point ahead.  turn, tilt and
                     * strafe go around the object, forward comes nearer, up rises */
    TP_HOST_TOP,    /* from above: forward and strafe glide, up rises, turn turns the map */
    TP_HOST_BOAT,   /* on the deck, where input moves it as TP_HOST_FREE does */
    TP_HOST_WAYS
} tp_host_way;

/* Changes the camera mode; the camera moves there at once.  The mode that is on
 * already starts again.  Sets the scene's camera.follow.  False: the scene has no boat
 * to stand on, there is no such mode, or memory is short; *err says which, nothing has
 * changed. */
bool tp_host_look(tp_host *host, tp_host_way way, tp_host_error *err);
tp_host_way tp_host_get_way(const tp_host *host);

/* -- pictures ------------------------------------------------------------------------ */

/* Draws the world as it is now.  The picture is valid until the next tp_host_draw,
 * tp_host_save_png, tp_host_set, tp_host_look or tp_host_close.  NULL: an earlier
 * change left no memory for it. */
const tp_host_picture *tp_host_draw(tp_host *host);

/* Draws, and writes the picture to a PNG with exactly its colours.  A file of this name is
 * replaced when the new one is complete; devices and pipes are written directly.  False: it
 * could not be written, *err says why, an old file is unchanged. */
bool tp_host_save_png(tp_host *host, const char *path, tp_host_error *err);

/* Pixel to water: the place under pixel (x, y) from the upper left corner, after the
 * last tick, within 1 px of the drawn one.  False: no water within 8000 m, or land or
 * a tank's wall stands before it. */
bool tp_host_pick(const tp_host *host, int32_t x, int32_t y, tp_vec3 *at);

TP_END_C
#endif
