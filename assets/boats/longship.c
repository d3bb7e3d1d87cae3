/* SPDX-License-Identifier: MIT */
/* Makes the longship: three meshes, their materials and their textures.
 *
 *     cc -std=c11 -O2 assets/boats/?*.c assets/textures/canvas.c -lpng -lm -o longship
 *     ./longship assets/boats
 *
 * longship.obj is the ship with all planks, shields and oars; longship-mid.obj has the same
 * parts in about 1200 triangles; longship-low.obj has the same lines in at most 300, with
 * painted shields. All meshes use longship.mtl, and have a lid over the hull, which is
 * never drawn and keeps the water out. Shapes are
 * computed in double precision and rounded so that each machine writes the same text
 * (mesh.h); the textures are painted in integers. The output is CC0-1.0. */
#include "longship.h"

#include <stdio.h>

static const char materials[] = "# SPDX-License-Identifier: CC0-1.0\n"
                                "# Normal maps: tangent space, green up.\n";

static const char lid[] = "\n# Never seen: water stays out of what it covers.\n"
                          "newmtl lid\nd 0\n";

typedef struct {
    const char *name, *diffuse, *specular, *map, *bump;
    int shininess;
} material;

static const material list[] = {
    { "oak", "0.86 0.80 0.74", "0.14 0.13 0.11", "wood.png", "wood-normal.png", 24 },
    { "tar", "0.36 0.32 0.30", "0.24 0.23 0.22", "wood.png", "wood-normal.png", 36 },
    { "deck", "1 0.97 0.92", "0.06 0.06 0.05", "wood.png", "wood-normal.png", 12 },
    { "carved", "0.92 0.84 0.74", "0.18 0.16 0.13", "carving.png", "carving-normal.png",
      30 },
    { "sail", "1 1 1", "0.03 0.03 0.03", "sail.png", "sail-normal.png", 6 },
    { "shield", "1 1 1", "0.12 0.12 0.12", "shields.png", NULL, 20 },
    { "iron", "0.30 0.30 0.32", "0.60 0.60 0.62", "mottle.png", NULL, 60 },
    { "bone", "0.98 0.93 0.80", "0.30 0.30 0.28", "mottle.png", NULL, 40 },
    { "rope", "0.80 0.72 0.56", "0.04 0.04 0.04", "rope.png", NULL, 8 },
};

static int write_materials(const char *dir)
{
    char path[1024];
    int length = snprintf(path, sizeof path, "%s/longship.mtl", dir);
    FILE *file = length < (int)sizeof path ? fopen(path, "wb") : NULL;
    if (file == NULL) {
        fprintf(stderr, "longship: %s/longship.mtl cannot be written\n", dir);
        return 3;
    }
    fputs(materials, file);
    for (size_t i = 0; i < sizeof list / sizeof list[0]; i++) {
        const material *m = &list[i];
        fprintf(file, "\nnewmtl %s\nKd %s\nKs %s\nNs %d\nmap_Kd %s\n", m->name,
                m->diffuse, m->specular, m->shininess, m->map);
        if (m->bump != NULL)
            fprintf(file, "map_Bump %s\n", m->bump);
    }
    fputs(lid, file);
    return fclose(file) == 0 ? 0 : 3;
}

int main(int argc, char **argv)
{
    static mesh full, middle, low;
    if (argc != 2) {
        fprintf(stderr, "usage: longship FOLDER\n");
        return 2;
    }
    static const char *const names[] = { "longship.obj", "longship-mid.obj" };
    for (int detail = FULL; detail <= MIDDLE; detail++) {
        mesh *m = detail == FULL ? &full : &middle;
        hull_build(m, (ship_detail)detail);
        posts_build(m, (ship_detail)detail);
        gear_build(m, (ship_detail)detail);
        rig_build(m, (ship_detail)detail);
        mesh_write(m, argv[1], names[detail], "longship.mtl");
    }

    hull_build_low(&low);
    posts_build_low(&low);
    gear_build_low(&low);
    rig_build_low(&low);
    mesh_write(&low, argv[1], "longship-low.obj", "longship.mtl");

    paint_all(argv[1]);
    return write_materials(argv[1]);
}
