/* SPDX-License-Identifier: MIT */
/* Shared by the stand-ins for makers' functions: the wires of one panel. D/C must not
 * change while bytes are being sent, and the last bytes of a DMA are sent after the DMA's
 * end. */
#ifndef SDK_H
#define SDK_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { DC = 4 };

extern uint32_t sdk_ms;             /* clock; each query advances it by one */

void sdk_dc(bool data);
void sdk_send(const uint8_t *bytes, size_t count);      /* returns after the last bit */
void sdk_dma(const uint8_t *bytes, size_t count);
bool sdk_dma_busy(void);            /* for two queries; for ever if stuck */
bool sdk_wire_busy(void);           /* true for one more query */
bool sdk_idle(void);                /* neither DMA nor wire is busy */
void sdk_pause(uint32_t ms);
#endif
