/* SPDX-License-Identifier: MIT */
/* Stand-in for the rest of the Pico SDK that ports/pico/sdk calls: declarations alone, to
 * compile against. */
#ifndef SDK_PICO_PROJECT_H
#define SDK_PICO_PROJECT_H
#include "tests/boards/sdk/pico.h"

typedef struct { uint32_t owner; } mutex_t;
enum { GPIO_FUNC_SPI = 1, GPIO_OUT = 1 };

bool set_sys_clock_khz(uint32_t khz, bool required);
uint32_t time_us_32(void);
void sleep_ms(uint32_t ms);
void gpio_init(uint pin);
void gpio_set_dir(uint pin, bool out);
void gpio_set_function(uint pin, int function);
uint spi_init(spi_inst_t *spi, uint hz);
int  dma_claim_unused_channel(bool required);
void mutex_init(mutex_t *mutex);
void mutex_enter_blocking(mutex_t *mutex);
void mutex_exit(mutex_t *mutex);
void multicore_launch_core1_with_stack(void (*entry)(void), uint32_t *stack, size_t bytes);
void multicore_fifo_push_blocking(uint32_t word);
uint32_t multicore_fifo_pop_blocking(void);
#endif
