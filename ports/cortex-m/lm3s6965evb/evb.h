/* SPDX-License-Identifier: MIT */
/* What of the evaluation board the program uses: its clock, the serial port over USB, the
 * display's wires, five buttons. */
#ifndef EVB_H
#define EVB_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define EVB_HZ 50000000u        /* of the processor, once evb_open has returned */

void evb_open(void);

/* Clocks since the last call, which must be within a third of a second. */
uint32_t evb_clocks(void);

/* A byte that was received; false: there is none. */
bool evb_byte(uint8_t *byte);
void evb_text(void *unused, const char *text);
void evb_number(uint32_t n, uint32_t base, int least_digits);

/* Of the display: lcd_wires. */
void evb_command(void *unused, uint8_t byte);
void evb_data(void *unused, const uint8_t *bytes, size_t count);
void evb_pause(void *unused, uint32_t ms);

uint32_t evb_buttons(void);     /* lines as board/buttons.h wants them */
#endif
