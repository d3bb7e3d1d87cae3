/* SPDX-License-Identifier: MIT */
/* The kit of a program that draws the baked scene. */
#ifndef TP_TESTS_FEATURES_H
#define TP_TESTS_FEATURES_H
#include "tidepool/tidepool.h"

extern const tp_kit features_kit;
#endif
