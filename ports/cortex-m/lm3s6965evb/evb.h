/* SPDX-License-Identifier: MIT */
/* Drivers of the evaluation board: clock, serial port over USB, the display's wires, five
 * buttons. */
#ifndef TP_CORTEX_M_LM3S6965EVB_EVB_H
#define TP_CORTEX_M_LM3S6965EVB_EVB_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define EVB_HZ 50000000u        /* processor clock after evb_open, Hz */

void evb_open(void);

/* Returns the clocks since the last call, which must be within a third of a second. */
uint32_t evb_clocks(void);

/* Fetches a received byte; returns false if none has arrived. */
bool evb_byte(uint8_t *byte);

/* Functions of lcd_wires for the display. */
void evb_command(void *unused, uint8_t byte);
void evb_data(void *unused, const uint8_t *bytes, size_t count);
void evb_pause(void *unused, uint32_t ms);

uint32_t evb_buttons(void);     /* lines in the format of serial/buttons.h */
#endif
