/* SPDX-License-Identifier: MIT */
/* Threads that wait for work and do it together with the caller.  They are started once:
 * starting them anew costs 19 us for one and 670 us for fifteen, waking them 7 and 96. */
#ifndef HOST_CREW_H
#define HOST_CREW_H
#include <stdint.h>

typedef struct crew crew;

/* Threads that a picture is drawn by where nobody says how many: one a processor, up to
 * eight. */
uint32_t crew_usual(void);

/* So many threads beside the caller; those that the system refuses are missing.  NULL:
 * none at all, which crew_do and crew_close take too. */
crew *crew_open(uint32_t threads);
void  crew_close(crew *c);

/* Calls task(user, i) at once from the caller, i = 0, and from threads 1.. as they wake;
 * those that wake when the caller's own call is over do not begin.  Returns when all that
 * began are done. */
void  crew_do(crew *c, void (*task)(void *user, uint32_t i), void *user);
#endif
