/* SPDX-License-Identifier: MIT */
/* Stand-in for ESP-IDF's spi_master and gpio drivers, and FreeRTOS. */
#include "tests/boards/sdk/sdk.h"

typedef int esp_err_t;
typedef uint32_t TickType_t;
typedef struct sdk_device *spi_device_handle_t;
typedef struct {
    uint32_t flags;
    size_t   length;            /* bits */
    union { const void *tx_buffer; uint8_t tx_data[4]; };
} spi_transaction_t;

enum { ESP_OK = 0, ESP_ERR_INVALID_STATE = 0x103, ESP_ERR_TIMEOUT = 0x107 };
#define SPI_TRANS_USE_TXDATA (1u << 3)
#define portMAX_DELAY        0xffffffffu
#define pdMS_TO_TICKS(ms)    ((TickType_t)(ms) / 10)    /* 100 Hz, the default of ESP-IDF */

static spi_transaction_t *sdk_queued;

static inline esp_err_t gpio_set_level(int pin, uint32_t level)
{
    if (pin == DC)
        sdk_dc(level);
    return ESP_OK;
}

static inline esp_err_t spi_device_polling_transmit(spi_device_handle_t d,
                                                    spi_transaction_t *t)
{
    (void)d;
    if (sdk_queued)
        return ESP_ERR_INVALID_STATE;
    sdk_send(t->flags & SPI_TRANS_USE_TXDATA ? t->tx_data : t->tx_buffer, t->length / 8);
    return ESP_OK;
}

static inline esp_err_t spi_device_queue_trans(spi_device_handle_t d, spi_transaction_t *t,
                                               TickType_t ticks)
{
    (void)d, (void)ticks;
    if (sdk_queued)
        return ESP_ERR_TIMEOUT;                         /* the queue has one entry */
    sdk_queued = t;
    sdk_dma(t->tx_buffer, t->length / 8);
    return ESP_OK;
}

static inline esp_err_t spi_device_get_trans_result(spi_device_handle_t d,
                                                    spi_transaction_t **t, TickType_t ticks)
{
    (void)d;
    if (!sdk_queued)
        return ESP_ERR_TIMEOUT;
    for (const uint32_t end = sdk_ms + 10 * ticks; !sdk_idle();)
        if (sdk_ms >= end)
            return ESP_ERR_TIMEOUT;
    *t = sdk_queued;
    sdk_queued = NULL;
    return ESP_OK;
}
#define PAUSE(ms) sdk_pause((pdMS_TO_TICKS(ms) + 1) * 10)
