/* SPDX-License-Identifier: MIT */
/* Text of a manual page: nothing in it acts as a macro or an escape. */
#define _POSIX_C_SOURCE 200809L
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include "../../ports/app/cli/roff.h"     /* before cmocka's macro `fail` */
#include <cmocka.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static char printed[4096];

/* Runs `print` with stdout sent to a file, and reads the file. */
static void catch(void (*print)(void))
{
    FILE *file = tmpfile();
    assert_non_null(file);
    fflush(stdout);
    const int kept = dup(1);
    assert_true(kept >= 0 && dup2(fileno(file), 1) == 1);
    print();
    roff_end();
    fflush(stdout);
    assert_int_equal(dup2(kept, 1), 1);
    close(kept);
    rewind(file);
    printed[fread(printed, 1, sizeof printed - 1, file)] = 0;
    fclose(file);
}

static void print_signs(void)
{
    roff_text(".TH x\\fB 'a-b' `c` ^~");
}

static void signs_of_roff_are_spelt_out(void **state)
{
    (void)state;
    catch(print_signs);
    assert_string_equal(printed, "\\&.TH x\\efB \\(aqa\\-b\\(aq \\(gac\\(ga \\(ha\\(ti\n");
}

static void print_dots(void)
{
    for (int i = 0; i < 60; i++)
        roff_text(".x 'y ");
}

static void no_line_of_text_begins_a_macro(void **state)
{
    (void)state;
    catch(print_dots);
    assert_non_null(strchr(printed, '\n'));
    for (const char *line = printed; *line; line = strchr(line, '\n') + 1) {
        assert_true(*line != '.' && *line != '\'');
        assert_true(strcspn(line, "\n") <= 80);
    }
}

static void print_paragraph(void)
{
    roff_text("one ");
    roff_bold("-b");
    roff_macro(".PP");
    roff_italic("'c");
}

static void macros_stand_alone(void **state)
{
    (void)state;
    catch(print_paragraph);
    assert_string_equal(printed, "one \\fB\\-b\\fR\n.PP\n\\fI\\(aqc\\fR\n");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(signs_of_roff_are_spelt_out),
        cmocka_unit_test(no_line_of_text_begins_a_macro),
        cmocka_unit_test(macros_stand_alone),
    };
    return cmocka_run_group_tests_name("roff", tests, NULL, NULL);
}
