/* SPDX-License-Identifier: MIT */
/* The components that a program needs by rule, before any picture is compared. */
#ifndef TP_TOOLS_BAKE_COMPONENT_NEEDS_H
#define TP_TOOLS_BAKE_COMPONENT_NEEDS_H
#include "component_search.h"

/* Returns the components that the search must not leave out. */
component_set components_needed(const component_search_request *request);

/* Removes parts that no other component of the set calls. */
void components_drop_uncalled(component_set *in);
#endif
