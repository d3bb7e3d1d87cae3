/* SPDX-License-Identifier: MIT */
/* The command line: one table of options serves every command. */
#ifndef TP_APP_CLI_ARGS_H
#define TP_APP_CLI_ARGS_H
#include <stdbool.h>
#include <stdint.h>
#include "interact/boards.h"
#include "app/scene/machine.h"
#include "tidepool/frame.h"

typedef struct {
    const char  *command, *scene;   /* name of the command; first name on the command line
                                     * (a scene, shell or command), NULL: none given; view
                                     * has a default */
    uint32_t     width, height;
    uint32_t     first, last;       /* first and last frame number, both included */
    uint32_t     every;             /* step between frames, from the first on */
    const char **settings;          /* "name=value", in the order of the command line */
    uint32_t     n_settings;
    const char  *out;               /* output file; NULL: the command's default, or none */
    tp_format    format;
    uint32_t     band, strip;       /* height, width of tiles, px; 0: automatic */
    uint32_t     threads;           /* number of threads, 0: not given */
    uint64_t     memory;            /* upper bound of memory, bytes; 0: unlimited */
    int32_t      visibility;        /* tp_visibility; auto: the scene's value */
    const char  *rung;              /* rungs of all kinds and effects; NULL: the scene's */
    bool         hash, stats, csv;
    bool         ladder;            /* print the steps of the scene's ladder */
    const plan_board *board;             /* plan for it; NULL: none */
    uint32_t     fps;               /* pictures a second on the board; 0: not given */
    uint32_t     step;              /* step of the ladder to draw, if `stepped` */
    bool         stepped;
    bool         strict;            /* refuse a mesh with missing or faulty files */
    bool         quiet;             /* no warnings on loading; set by no option */
    bool         stream;            /* stream grid vertices; `memory` may force it */
    uint32_t     kept;              /* bytes of a tile's scratch for streamed lines */
    const char  *expect;            /* file with a list of hashes */
    const char  *tape;              /* tape of inputs: render plays, view records */
    const char  *vectors;           /* folder of tables */
    bool         write;             /* rewrite old names in the scene's file */
    const char  *name;              /* prefix of baked names; NULL: the scene's name */
    uint32_t     texels;            /* bound of a texture's sides, texels; 0: none */
    const char  *only;              /* prefix of parameters' names; NULL: all */
    const machine *machine;         /* build of the core; NULL: the best */
    bool         sized;             /* true if --size was given */
    uint32_t     points;            /* of the benchmark's grid, per side; 0: not given */
    int32_t      work;              /* bench_work, -1: not given */
    bool         rungs, peers;
    const char **names;             /* names, of commands that take several */
    uint32_t     n_names;
    uint32_t     jobs;              /* number of parallel jobs, 0: not given */
    const char  *from;              /* folder of charts; NULL: the project's */
    bool         small, list, collect;
    bool         resume;            /* continue the last sweep or preview session */
    const char  *on, *device;       /* port and path of the raw screen; NULL: default */
    const char  *keep;              /* file that keeps the state of the world */
    uint32_t     scale, ui;         /* pixel scale, 1..16; letters, percent; 0: not given */
    const char  *play, *keys;       /* file of a tape to play; file of keys */
    bool         no_panel;
    bool         scene_page;        /* print the manual page of scenes */
    bool         hold, counted, formatted;  /* --hold, --frames, --format were given */
    const char  *with, *without;    /* components of a baked program's list, by commas */
    bool         no_input;
    bool         help;
} options;

/* Bits of commands, for the masks of the table. */
enum { FOR_RENDER = 1, FOR_VIEW = 2, FOR_PARAMS = 4, FOR_SCENES = 8, FOR_CHECK = 16,
       FOR_BAKE = 32, FOR_PLAN = 64, FOR_BENCH = 128, FOR_CHARTS = 256, FOR_JOIN = 512,
       FOR_SHOW = 1024, FOR_MANUAL = 2048, FOR_COMPLETION = 4096, FOR_HELP = 8192,
       FOR_VERSION = 16384 };

/* Reads the command line.  command: one of FOR_...; argv[0]: name of the command.  Returns
 * EXIT_USAGE after printing the reason.  In every case the caller frees o->settings. */
int args_read(options *o, unsigned command, int argc, char **argv);

/* Returns the number of frames that the command line selects. */
static inline uint32_t args_frames(const options *o)
{
    return (o->last - o->first) / o->every + 1;
}

/* Prints the options of a command on stdout, one option per line. */
void args_print(unsigned command);
#endif
