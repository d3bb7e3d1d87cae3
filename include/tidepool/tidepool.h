/* SPDX-License-Identifier: MIT */
/* Tidepool: water for small computers.  Everything public, in one include. */
#ifndef TP_TIDEPOOL_H
#define TP_TIDEPOOL_H
#include "tidepool/arena.h"
#include "tidepool/asset.h"
#include "tidepool/clock.h"
#include "tidepool/depth.h"
#include "tidepool/drop.h"
#include "tidepool/engine.h"
#include "tidepool/foam.h"
#include "tidepool/frame.h"
#include "tidepool/fx.h"
#include "tidepool/program.h"
#include "tidepool/language.h"
#include "tidepool/light.h"
#include "tidepool/ocean.h"
#include "tidepool/pixel.h"
#include "tidepool/plan.h"
#include "tidepool/pool.h"
#include "tidepool/ring.h"
#include "tidepool/scene.h"
#include "tidepool/status.h"
#include "tidepool/tape.h"
#include "tidepool/version.h"
#include "tidepool/wave.h"
#endif
