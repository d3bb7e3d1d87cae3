/* SPDX-License-Identifier: MIT */
/* The program of a program that draws the baked scene. */
#ifndef TP_TESTS_FEATURES_H
#define TP_TESTS_FEATURES_H
#include "tidepool/tidepool.h"

extern const tp_program features_program;
#endif
