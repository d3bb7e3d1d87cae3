/* SPDX-License-Identifier: MIT */
/* The command line: one table of options that every command draws from. */
#ifndef HOST_ARGS_H
#define HOST_ARGS_H
#include <stdbool.h>
#include <stdint.h>
#include "machine.h"
#include "tidepool/frame.h"

typedef struct {
    const char  *command, *scene;   /* its first name, whatever it is of, NULL if none is
                                     * given; view then has its own */
    uint32_t     width, height;
    uint32_t     first, last;       /* frames, both included */
    uint32_t     every;             /* so-manieth of them alone, from the first on */
    const char **settings;          /* "name=value", in their order */
    uint32_t     n_settings;
    const char  *out;               /* NULL: the command's own, or none */
    tp_format    format;
    uint32_t     band, strip;       /* sides of tiles, 0: the program chooses */
    uint32_t     threads;           /* 0: not given */
    uint64_t     memory;            /* bytes that it may take, 0: any */
    int32_t      visibility;        /* tp_visibility; auto: the scene's own */
    bool         hash, stats, csv;
    bool         strict;            /* what a mesh lacks is refused, not left out */
    bool         quiet;             /* or left out without a word; of no option */
    bool         stream;            /* also if it takes that to keep to `memory` */
    const char  *expect;            /* list of hashes */
    const char  *tape;              /* of inputs: render plays it, view records it */
    const char  *vectors;           /* folder of tables */
    const char  *name;              /* what baked names begin with, NULL: the scene's */
    uint32_t     texels;            /* of a picture's longer side at the most, 0: any */
    const char  *only;              /* parameters' names begin so, NULL: any */
    const machine *machine;         /* whose program draws; NULL: the best one */
    bool         sized;             /* --size was given */
    uint32_t     points;            /* of the benchmark's grid, 0: not given */
    int32_t      work;              /* bench_work, -1: not given */
    bool         rungs, peers;
    const char **names;             /* of commands that take several */
    uint32_t     n_names;
    uint32_t     jobs;              /* at a time, 0: not given */
    const char  *from;              /* folder of charts; NULL: the project's */
    bool         small, list, collect;
    bool         resume;            /* a sweep, or what the preview did last */
    const char  *on, *device;       /* the raw screen's port and path; NULL: its own */
    const char  *keep;              /* file of the world's bytes */
    uint32_t     scale, ui;         /* of pixels; of letters, in percent; 0: not given */
    const char  *play, *keys;       /* of inputs; of keys */
    bool         no_panel;
    bool         scene_page;        /* of the manual */
    bool         hold, counted, formatted;  /* --frames, --format were given */
    const char  *with, *without;    /* pieces of a baked program's list, by commas */
    bool         no_input;
    bool         help;
} options;

/* Commands, for the table's masks. */
enum { FOR_RENDER = 1, FOR_VIEW = 2, FOR_PARAMS = 4, FOR_SCENES = 8, FOR_CHECK = 16,
       FOR_BAKE = 32, FOR_PLAN = 64, FOR_BENCH = 128, FOR_CHARTS = 256, FOR_JOIN = 512,
       FOR_SHOW = 1024, FOR_MANUAL = 2048, FOR_COMPLETION = 4096, FOR_HELP = 8192,
       FOR_VERSION = 16384 };

/* `command` is one of FOR_...; argv[0] is its name.  EXIT_USAGE: said why.  The caller
 * frees settings in any case. */
int args_read(options *o, unsigned command, int argc, char **argv);

/* So many frames does the command line ask for. */
static inline uint32_t args_frames(const options *o)
{
    return (o->last - o->first) / o->every + 1;
}

/* The options of a command, one a line, on stdout. */
void args_print(unsigned command);
#endif
