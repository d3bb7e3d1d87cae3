/* SPDX-License-Identifier: MIT */
/* The program's commands.  Each takes its own name as argv[0], returns an exit code and
 * has said why it is not 0. */
#ifndef HOST_COMMANDS_H
#define HOST_COMMANDS_H
int render_command(int argc, char **argv);
int view_command(int argc, char **argv);
int show_command(int argc, char **argv);
int scenes_command(int argc, char **argv);
int params_command(int argc, char **argv);
int bake_command(int argc, char **argv);
int check_command(int argc, char **argv);
int plan_command(int argc, char **argv);
int bench_command(int argc, char **argv);
int charts_command(int argc, char **argv);
int join_command(int argc, char **argv);

/* Ends what was printed on standard output: a full disk or a closed pipe is an error. */
int finish_stdout(void);
#endif
