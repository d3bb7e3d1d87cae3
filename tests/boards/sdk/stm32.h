/* SPDX-License-Identifier: MIT */
/* Stand-in for the STM32 HAL: SPI by DMA, whose interrupt waits for the last byte. */
#include "tests/boards/sdk/sdk.h"

typedef struct { int unused; } SPI_HandleTypeDef, GPIO_TypeDef;
typedef enum { GPIO_PIN_RESET, GPIO_PIN_SET } GPIO_PinState;
typedef enum { HAL_OK, HAL_ERROR, HAL_BUSY, HAL_TIMEOUT } HAL_StatusTypeDef;
typedef enum { HAL_SPI_STATE_READY = 1, HAL_SPI_STATE_BUSY = 2 } HAL_SPI_StateTypeDef;

static SPI_HandleTypeDef hspi1;
static GPIO_TypeDef sdk_port;
#define GPIOB (&sdk_port)

static inline void HAL_GPIO_WritePin(GPIO_TypeDef *port, uint16_t pin, GPIO_PinState state)
{
    if (port == GPIOB && pin == DC)
        sdk_dc(state == GPIO_PIN_SET);
}

static inline HAL_StatusTypeDef HAL_SPI_Transmit(SPI_HandleTypeDef *spi, uint8_t *bytes,
                                                 uint16_t count, uint32_t timeout)
{
    (void)spi, (void)timeout;
    sdk_send(bytes, count);
    return HAL_OK;
}

static inline HAL_StatusTypeDef HAL_SPI_Transmit_DMA(SPI_HandleTypeDef *spi, uint8_t *bytes,
                                                     uint16_t count)
{
    (void)spi;
    sdk_dma(bytes, count);
    return HAL_OK;
}

static inline HAL_SPI_StateTypeDef HAL_SPI_GetState(SPI_HandleTypeDef *spi)
{
    (void)spi;
    return sdk_idle() ? HAL_SPI_STATE_READY : HAL_SPI_STATE_BUSY;
}

static inline HAL_StatusTypeDef HAL_SPI_Abort(SPI_HandleTypeDef *spi)
{
    (void)spi;
    return HAL_OK;
}

static inline uint32_t HAL_GetTick(void) { return sdk_ms; }
#define PAUSE(ms) sdk_pause(ms)
