/* SPDX-License-Identifier: MIT */
/* Opens the files of the folder assets; TP_ROOT is the project's root for tests that run
 * elsewhere. */
#ifndef TP_TESTS_LIB_ASSET_FILES_H
#define TP_TESTS_LIB_ASSET_FILES_H
#include <stdio.h>
#include <stdlib.h>

static inline FILE *open_asset(const char *name)
{
    const char *root = getenv("TP_ROOT");
    char path[1024];
    assert_true(snprintf(path, sizeof path, "%s/assets/%s", root ? root : ".", name)
                < (int)sizeof path);
    FILE *file = fopen(path, "rb");
    if (!file)
        fail_msg("%s cannot be opened", path);
    return file;
}
#endif
