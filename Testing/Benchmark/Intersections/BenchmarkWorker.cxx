// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkWorker.h"

#include <csignal>
#include <cstdlib>
#include <stdexcept>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{
// Disables core files and limits memory.
void SetLimits()
{
  const rlimit none{ 0, 0 };
  setrlimit(RLIMIT_CORE, &none);
  const rlim_t bytes = rlim_t(4) << 30;
  const rlimit most{ bytes, bytes };
  setrlimit(RLIMIT_AS, &most);
}

// Never returns.
void DoItems(int first, int number, unsigned int seconds, int output,
  const std::function<BenchmarkWorker::Figures(int)>& work)
{
  SetLimits();
  bool isWritten = true;
  for (int item = first; isWritten && item < number; ++item)
  {
    alarm(seconds);
    const BenchmarkWorker::Figures figures = work(item);
    isWritten = write(output, figures.data(), sizeof(figures)) == sizeof(figures);
  }
  _exit(isWritten ? EXIT_SUCCESS : EXIT_FAILURE);
}
}

BenchmarkWorker::BenchmarkWorker(
  int number, unsigned int seconds, const std::function<Figures(int)>& work)
{
  while (this->Finished + this->Crashes + this->Hangs < number)
  {
    int ends[2];
    const pid_t child = pipe(ends) == 0 ? fork() : -1;
    if (child < 0)
    {
      throw std::runtime_error("no process for the benchmark's worker");
    }
    if (child == 0)
    {
      close(ends[0]);
      DoItems(this->Finished + this->Crashes + this->Hangs, number, seconds, ends[1], work);
    }
    close(ends[1]);
    Figures figures;
    while (read(ends[0], figures.data(), sizeof(figures)) == sizeof(figures))
    {
      ++this->Finished;
      for (std::size_t i = 0; i < figures.size(); ++i)
      {
        this->Sums[i] += figures[i];
      }
    }
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM)
    {
      ++this->Hangs;
    }
    else if (!WIFEXITED(status) || WEXITSTATUS(status) != EXIT_SUCCESS)
    {
      ++this->Crashes;
    }
  }
}
