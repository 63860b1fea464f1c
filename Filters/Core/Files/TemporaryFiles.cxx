// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/TemporaryFiles.h"

#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <mutex>
#include <unistd.h>

namespace relevo
{
// The handler may read an entry at any time, so entries are reused but never freed.
struct TemporaryFiles::Entry
{
  char FileName[PATH_MAX];
  pid_t Process = 0; // a forked child must not remove the files of its parent
  std::atomic<bool> IsThere{ false };
  Entry* Next = nullptr;
};

namespace
{
using Entry = TemporaryFiles::Entry;

constexpr int HandledSignals[] = { SIGINT, SIGTERM, SIGHUP };

std::mutex Mutex; // locked while the following variables change
std::atomic<Entry*> First{ nullptr };
int NumberOfFiles = 0;

// Calls only functions that POSIX allows in signal handlers.
void RemoveFiles(int signal)
{
  const int oldError = errno;
  for (Entry* entry = First; entry; entry = entry->Next)
  {
    if (entry->IsThere && entry->Process == getpid())
    {
      unlink(entry->FileName);
    }
  }
  errno = oldError;
  std::signal(signal, SIG_DFL);
  raise(signal); // is delivered when this function returns
}

using Handler = void (*)(int);

// Replaces the action of a signal if it is the expected one.
void Exchange(int signal, Handler expected, Handler handler)
{
  struct sigaction action;
  if (sigaction(signal, nullptr, &action) == 0 && !(action.sa_flags & SA_SIGINFO) &&
    action.sa_handler == expected)
  {
    action.sa_handler = handler;
    sigaction(signal, &action, nullptr);
  }
}

void HandleSignals()
{
  for (int signal : HandledSignals)
  {
    Exchange(signal, SIG_DFL, RemoveFiles);
  }
  Exchange(SIGXFSZ, SIG_DFL, SIG_IGN);
}

void ReleaseSignals()
{
  for (int signal : HandledSignals)
  {
    Exchange(signal, RemoveFiles, SIG_DFL);
  }
}

Entry* FindFree()
{
  for (Entry* entry = First; entry; entry = entry->Next)
  {
    if (!entry->IsThere)
    {
      return entry;
    }
  }
  auto* entry = new Entry;
  entry->Next = First;
  First = entry;
  return entry;
}
}

TemporaryFiles::Entry* TemporaryFiles::Add(const std::string& fileName)
{
  const std::lock_guard<std::mutex> lock(Mutex);
  Entry* entry = FindFree();
  entry->FileName[fileName.copy(entry->FileName, PATH_MAX - 1)] = '\0';
  entry->Process = getpid();
  entry->IsThere = true;
  if (NumberOfFiles++ == 0)
  {
    HandleSignals();
  }
  return entry;
}

void TemporaryFiles::Forget(Entry* entry)
{
  const std::lock_guard<std::mutex> lock(Mutex);
  entry->IsThere = false;
  if (--NumberOfFiles == 0)
  {
    ReleaseSignals();
  }
}
}
