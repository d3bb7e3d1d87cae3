/* SPDX-License-Identifier: MIT */
/* Finds the components that a scene needs: without such a component, the worlds or
 * pictures of a dry run would differ, or the frame would count something as dropped. */
#ifndef TP_TOOLS_BAKE_COMPONENT_SEARCH_H
#define TP_TOOLS_BAKE_COMPONENT_SEARCH_H
#include "components.h"
#include "dry_run.h"
#include "tidepool/frame.h"

/* The worlds of a search, for searches of scenes that differ by rungs only: rungs never
 * change the world. */
typedef struct {
    bool      known;
    dry_run   run;              /* the caller closes it */
    component_set moving;       /* with these components the worlds move right */
} component_search_worlds;

typedef struct {
    const tp_scene  *scene;     /* with all rungs named */
    const tp_assets *assets;
    const tp_assets *baked;     /* assets of the program */
    const tp_assets *lean;      /* fewer assets, used if they suffice; or NULL */
    tp_config        config;
    component_terms  terms;
    component_set    with;      /* components that stay in any case */
    component_set    without;   /* components that are left out in any case */
    bool             acts;
    component_search_worlds *worlds;    /* taken if known, else set; NULL: not kept */
} component_search_request;

typedef struct {
    component_set in;
    component_set lacks;        /* components of `without` that the scene asks for */
    component_set refused;      /* modules that a changed scene may not switch on */
    bool      lean;             /* true: `lean` assets suffice */
    uint32_t  pictures;         /* number of pictures compared */
} component_search_result;

/* Searches, and compares the pictures of all cameras with pictures of all components but
 * `without`.  Returns EXIT_CHECK after a message if a picture or the world differs;
 * EXIT_INPUT. */
int component_search_run(component_search_result *found,
                         const component_search_request *request);
#endif
