/* SPDX-License-Identifier: MIT */
/* Stand-in for the Pico SDK's hardware_spi, hardware_dma, hardware_gpio and pico_time; what
 * only ports/pico/sdk calls is declared in pico_project.h. */
#include "tests/boards/sdk/sdk.h"

typedef unsigned uint;
typedef uint64_t absolute_time_t;
typedef struct { volatile uint32_t dr; } spi_hw_t;
typedef struct { int size; uint dreq; } dma_channel_config;
typedef struct { spi_hw_t hw; } spi_inst_t;
enum { DMA_SIZE_8, DMA_SIZE_16, DMA_SIZE_32 };

static spi_inst_t sdk_spi;
static spi_inst_t *const spi0 = &sdk_spi;

static inline void gpio_put(uint pin, bool value)
{
    if (pin == DC)
        sdk_dc(value);
}

static inline int spi_write_blocking(spi_inst_t *spi, const uint8_t *bytes, size_t count)
{
    (void)spi;
    sdk_send(bytes, count);
    return (int)count;
}

static inline spi_hw_t *spi_get_hw(spi_inst_t *spi) { return &spi->hw; }
static inline uint spi_get_dreq(spi_inst_t *spi, bool tx)
{
    (void)spi;
    return tx ? 16 : 17;
}
static inline bool spi_is_busy(const spi_inst_t *spi) { (void)spi; return sdk_wire_busy(); }

static inline dma_channel_config dma_channel_get_default_config(uint channel)
{
    (void)channel;
    return (dma_channel_config){ DMA_SIZE_32, 0x3f };
}

static inline void channel_config_set_transfer_data_size(dma_channel_config *c, int size)
{
    c->size = size;
}

static inline void channel_config_set_dreq(dma_channel_config *c, uint dreq)
{
    c->dreq = dreq;
}

/* Starts `count` transfers of the configured size, paced by the SPI's transmit side. */
static inline void dma_channel_configure(uint channel, const dma_channel_config *c,
                                         volatile void *to, const volatile void *from,
                                         uint count, bool start)
{
    (void)channel;
    if (start && c->size == DMA_SIZE_8 && c->dreq == 16 && to == &sdk_spi.hw.dr)
        sdk_dma((const uint8_t *)(uintptr_t)from, count);
}

static inline bool dma_channel_is_busy(uint channel)
{
    (void)channel;
    return sdk_dma_busy();
}
static inline void dma_channel_abort(uint channel) { (void)channel; }
static inline absolute_time_t make_timeout_time_ms(uint32_t ms) { return sdk_ms + ms; }
static inline bool time_reached(absolute_time_t t) { return sdk_ms >= t; }
#define PAUSE(ms) sdk_pause(ms)
