/* SPDX-License-Identifier: MIT */
/* Tidepool: water for small computers.  This header includes the whole public interface
 * and adds the simple way to use it: an engine in one block of memory.
 *
 *     static tp_scene scene;
 *     static uint64_t memory[40 << 10];
 *
 *     tp_engine *sea;
 *     tp_tile    tile;
 *     const tp_config config = { .width = 320, .height = 240 };
 *
 *     tp_scene_init(&scene);
 *     if (tp_engine_init(&sea, &config, &scene, memory, sizeof memory, NULL))
 *         return 1;
 *     for (;; tp_engine_step(sea, NULL)) {
 *         tp_engine_begin(sea);
 *         while (tp_engine_next_tile(sea, &tile))
 *             show(&tile);
 *     }
 *
 * An engine is a world, a frame and the scratch of one tile.  An application that draws
 * with several threads, keeps snapshots or draws one world from two cameras uses these
 * parts directly: tidepool/world.h, tidepool/frame.h.  One thread at a time may call the
 * functions of an engine; two engines share nothing.
 *
 * Order of calls for an animation: tp_engine_apply if numbers of the scene changed,
 * tp_engine_step, tp_world_set_camera if the application moves the camera,
 * tp_engine_begin, tp_frame_project, then the tiles.  A step is 1/60 s: at 30 pictures a
 * second call tp_engine_step twice for each picture. */
#ifndef TP_TIDEPOOL_H
#define TP_TIDEPOOL_H
#include <stdbool.h>
#include <stddef.h>
#include "tidepool/assets.h"
#include "tidepool/fixed.h"
#include "tidepool/frame.h"
#include "tidepool/modules.h"
#include "tidepool/scene.h"
#include "tidepool/status.h"
#include "tidepool/world.h"

TP_BEGIN_C

/* The version, defined here alone.
 *
 * The same version draws the same bits on every machine.  MAJOR rises when a program that
 * used the API no longer compiles or changes its meaning, MINOR when pictures change or
 * the API grows, PATCH otherwise.  While MAJOR is 0, MINOR rises when programs or scene
 * files must change, PATCH when pictures change. */
#define TP_VERSION_MAJOR 0
#define TP_VERSION_MINOR 2
#define TP_VERSION_PATCH 3
#define TP_VERSION_DATE  "2026-11-28"

/* The version as one number, to compare in #if: MAJOR 1000000 + MINOR 1000 + PATCH;
 * 1002003 is 1.2.3. */
#define TP_VERSION \
    (TP_VERSION_MAJOR * 1000000 + TP_VERSION_MINOR * 1000 + TP_VERSION_PATCH)

/* "MAJOR.MINOR.PATCH" of this header. */
#define TP_VERSION_TEXT \
    TP_VERSION_WORD(TP_VERSION_MAJOR) "." \
    TP_VERSION_WORD(TP_VERSION_MINOR) "." \
    TP_VERSION_WORD(TP_VERSION_PATCH)
#define TP_VERSION_WORD(number)  TP_VERSION_WORD_(number)
#define TP_VERSION_WORD_(number) #number

/* Returns the TP_VERSION_TEXT that the library was compiled with: compare to detect a
 * program linked with another version. */
const char *tp_version(void);

/* -- the engine ---------------------------------------------------------------------- */

typedef struct tp_engine tp_engine;     /* lies at the start of the memory */

/* Returns the memory in bytes for an engine of this config and scene.  0: the config or
 * the scene cannot be used; tp_engine_init tells why. */
size_t tp_engine_bytes(const tp_config *config, const tp_scene *scene);

/* Makes an engine at tick 0 in `memory`: at least tp_engine_bytes() bytes, aligned to 8.
 * The config is copied.  Memory, scene, program and pictures must stay in place while the
 * engine is used; nothing has to be closed.  After a failure the memory holds no engine.
 *  - TP_E_NULL, TP_E_ALIGN: err->word is the argument; TP_E_NOSPACE: `bytes` are too few
 *  - as tp_frame_init and tp_world_init: the config or the scene cannot be used */
tp_status tp_engine_init(tp_engine **engine, const tp_config *config,
                         const tp_scene *scene, void *memory, size_t bytes, tp_error *err);

/* Advances the water by 1/60 s times the scene's clock.scale.  NULL input: no input.
 * Returns the name of a part that the program lacks, as tp_world_step. */
const char *tp_engine_step(tp_engine *engine, const tp_input *input);

/* tp_engine_begin begins a picture of the water in its present state.  tp_engine_next_tile
 * draws the next tile, from left to right and from top to bottom, and returns false after
 * the last one.  The pixels of a tile are valid until the next call. */
void tp_engine_begin(tp_engine *engine);
bool tp_engine_next_tile(tp_engine *engine, tp_tile *tile);

/* Applies changed numbers of the scene; the next picture shows them, even without a step.
 * After a failure correct the scene and apply again before the next step or picture.
 *  - as tp_world_init: the scene cannot be used
 *  - TP_E_WORLD: the scene needs another layout of the memory (a pool of another size, one
 *    wave more): call tp_engine_init again */
tp_status tp_engine_apply(tp_engine *engine, tp_error *err);

/* Returns the engine's world, for the functions of tidepool/world.h (cameras, pushes,
 * height queries), and the engine's frame, for the functions of tidepool/frame.h
 * (projecting, picking, rows of depth). */
tp_world *tp_engine_world(tp_engine *engine);
tp_frame *tp_engine_frame(tp_engine *engine);

TP_END_C
#endif
