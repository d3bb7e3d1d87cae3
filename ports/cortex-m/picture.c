/* SPDX-License-Identifier: MIT */
/* What a board draws that has memory for everything: every effect, in bands as wide as
 * the picture. */
#include "board.h"

const tp_kit *const board_kit = &tp_kit_all;
const tp_frame_config board_picture = { 320, 240, 0, 16, TP_FORMAT_RGB565 };
