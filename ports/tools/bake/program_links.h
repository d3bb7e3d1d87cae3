/* SPDX-License-Identifier: MIT */
/* Code, constants and the deepest chain of calls that a program links, by the tables that
 * tests/budgets/code-sizes.sh measures. */
#ifndef TP_TOOLS_BAKE_PROGRAM_LINKS_H
#define TP_TOOLS_BAKE_PROGRAM_LINKS_H
#include "component_search.h"
#include "program_memory.h"

/* Adds code and constants of a list, and raises m->stack to its deepest chain. */
void program_links_add(program_memory *m, const component_search_result *found,
                       const component_terms *terms);
#endif
