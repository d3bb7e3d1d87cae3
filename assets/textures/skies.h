/* SPDX-License-Identifier: MIT */
/* Skies as cubes: six pictures each, DIR/day-east.png and so on, 256x256 RGBA.
 *
 * A face is what an eye in the cube's middle sees along an axis, upright on the four
 * sides; the lower edge of `up` joins the south, and so does the upper edge of `down`.
 * Alpha is light beyond white [F8], and only the sun or the moon has any.
 *
 * day    cumulus, the sun in the south-west (heading 225), 42 degrees up
 * dusk   lit bars of cloud, the sun in the west (heading 270), 6 degrees up
 * night  the Milky Way, the moon in the north (heading 6), 20 degrees up */
#ifndef SKIES_H
#define SKIES_H

void make_skies(const char *dir);

#endif
