/* SPDX-FileCopyrightText: Copyright (c) The Relevo developers
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * A library that run.sh loads into ranks. Open MPI calls sched_yield() again and again while a rank
 * waits for a message. With more ranks than processors, the ranks that wait would take most of the
 * time from those that draw. This function sleeps instead, at most 0.2 ms at a time while the wait
 * goes on.
 */
#define _GNU_SOURCE
#include <time.h>

enum
{
  FirstPause = 10000, /* nanoseconds */
  LongestPause = 200000,
  Work = 50000 /* a longer time between two calls is no wait */
};

static long long read_clock(void)
{
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return 1000000000LL * now.tv_sec + now.tv_nsec;
}

int sched_yield(void)
{
  static _Thread_local long long last = 0;
  static _Thread_local long pause = 0;
  if (read_clock() - last > Work)
  {
    pause = 0;
  }
  struct timespec length = { 0, pause };
  nanosleep(&length, NULL);
  pause = pause == 0 ? FirstPause : 2 * pause;
  pause = pause < LongestPause ? pause : LongestPause;
  last = read_clock();
  return 0;
}
