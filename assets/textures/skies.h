/* SPDX-License-Identifier: MIT */
/* Skies as cube maps: six pictures each, DIR/day-east.png and so on, 256x256 RGBA.
 *
 * A face is the view of an eye at the cube's centre along an axis, upright on the four
 * sides; the lower edge of `up` joins the south face, and the upper edge of `down` joins
 * the south face too. Alpha is brightness above white [F8]; only the sun or the moon has
 * alpha.
 *
 * day    cumulus, the sun in the south-west (heading 225), 42 degrees up
 * dusk   lit bars of cloud, the sun in the west (heading 270), 6 degrees up
 * night  the Milky Way, the moon in the north (heading 6), 20 degrees up */
#ifndef SKIES_H
#define SKIES_H

void make_skies(const char *dir);

#endif
