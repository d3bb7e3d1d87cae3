/* SPDX-License-Identifier: MIT */
/* What stand-ins for makers' functions share: the wires of one panel.  D/C must not move
 * while bytes are on their way, and the last bytes of a DMA leave after its end. */
#ifndef SDK_H
#define SDK_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { DC = 4 };

extern uint32_t sdk_ms;             /* the clock, which each question moves by one */

void sdk_dc(bool data);
void sdk_send(const uint8_t *bytes, size_t count);      /* returns when it is sent */
void sdk_dma(const uint8_t *bytes, size_t count);
bool sdk_dma_busy(void);            /* for two questions; for ever if the panel is stuck */
bool sdk_wire_busy(void);           /* for one more after that */
bool sdk_idle(void);                /* neither */
void sdk_pause(uint32_t ms);
#endif
