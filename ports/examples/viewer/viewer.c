/* SPDX-License-Identifier: MIT */
/* Opens a scene file, moves the camera around it for a number of frames and saves the last
 * picture.
 *     viewer SCENE.ini FRAMES PICTURE.png */
#include <stdio.h>
#include <stdlib.h>
#include <tidepool/host.h>
#include "tidepool/world.h"

static int fail(const tp_host_error *err)
{
    fprintf(stderr, "%s\n", err->text);
    return 1;
}

/* Converts 16.16 to metres. */
static double metres(tp_fx x)
{
    return x / 65536.0;
}

int main(int argc, char **argv)
{
    const tp_host_config config = { .width = 320, .height = 240 };
    const tp_input round = { .turn = TP_DEG(1) };
    tp_host_error err;
    tp_host_value value;
    tp_vec3 at;

    if (argc != 4)
        return fprintf(stderr, "usage: viewer SCENE.ini FRAMES PICTURE.png\n"), 2;
    tp_host *host = tp_host_open(argv[1], &config, &err);
    if (!host)
        return fail(&err);
    if (err.text[0])
        fprintf(stderr, "%s\n", err.text); /* warnings */
    for (uint32_t i = 0; tp_host_changed(host, i, &value); i++)
        printf("%s:%u: %s = %s\n", argv[1], (unsigned)value.line, value.name,
               value.value);

    if (atoi(argv[2]) > 0)
        tp_host_look(host, TP_HOST_ORBIT, NULL);
    for (int i = 0; i < atoi(argv[2]); i++)
        tp_host_step(host, &round);
    if (tp_host_pick(host, 160, 120, &at))
        printf("in the middle: water at %.2f %.2f %.2f\n", metres(at.x), metres(at.y),
               metres(at.z));
    else
        printf("in the middle: no water\n");
    const int failed = tp_host_save_png(host, argv[3], &err) ? 0 : fail(&err);
    tp_host_close(host);
    return failed;
}
