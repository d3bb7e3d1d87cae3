/* SPDX-License-Identifier: MIT */
/* tidepool check: converts numbers of tables to the core's formats and back.  The ranges of
 * columns keep every number within its format. */
#include <math.h>
#include "check.h"

tp_fx check_fx(double x)
{
    return (tp_fx)lround(x * 65536);
}

tp_q30 check_q30(double x)
{
    return (tp_q30)lround(x * TP_Q30_ONE);
}

tp_turn check_turn(double radians)
{
    const double turns = radians / (2 * CHECK_PI);
    return (tp_turn)(int64_t)llround((turns - floor(turns)) * 4294967296.0);
}

double check_metres(tp_fx x)
{
    return x / 65536.0;
}

double check_radians(tp_turn angle)
{
    return (int32_t)angle * ((2 * CHECK_PI) / 4294967296.0);
}

double check_wrapped(double radians)
{
    return remainder(radians, (2 * CHECK_PI));
}

/* Computes the angle by cross and dot product: accurate for small angles too. */
double check_angle(tp_dir3 got, const double want[3])
{
    const double x = got.x, y = got.y, z = got.z;
    const double cx = y * want[2] - z * want[1], cy = z * want[0] - x * want[2];
    const double cz = x * want[1] - y * want[0];
    const double dot = x * want[0] + y * want[1] + z * want[2];
    return atan2(sqrt(cx * cx + cy * cy + cz * cz), dot) * (180 / CHECK_PI);
}

double check_percent(double got, double want)
{
    return 100 * (got / want - 1);
}

double check_rounding(double x)
{
    return fabs(check_metres(check_fx(x)) - x);
}

double check_share(double x)
{
    return x > 0 ? check_rounding(x) / x : 0;
}

double check_excess(double error, double lost)
{
    return fabs(error) > lost ? error - copysign(lost, error) : 0;
}
