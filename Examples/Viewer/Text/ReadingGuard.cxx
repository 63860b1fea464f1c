// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Text/ReadingGuard.h"

#include "Text/PrintableText.h"
#include "Text/ViewerText.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <sys/resource.h>
#include <unistd.h>

namespace
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool IsSanitized = true;
#elif defined(__has_feature)
constexpr bool IsSanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) ||
  __has_feature(memory_sanitizer);
#else
constexpr bool IsSanitized = false;
#endif

// The time without progress, which is 120 seconds for a file of 100 MiB.
constexpr int MinimumSeconds = 20;
constexpr double SecondsPerMiB = 1.0;
constexpr double MinimumProgress = 0.01;

// Prepared in advance, because a handler may only write and exit.
struct LastLine
{
  char Text[4096] = {};
  std::size_t Length = 0;

  std::string Get() const { return std::string(this->Text, this->Length); }

  void Set(const std::string& text)
  {
    this->Length = 0;
    std::memcpy(this->Text, text.data(), std::min(text.size(), sizeof(this->Text) - 1));
    this->Length = std::min(text.size(), sizeof(this->Text) - 1);
    this->Text[this->Length] = '\n';
  }

  [[noreturn]] void WriteAndExit() const
  {
    // Several threads may crash at once.
    static std::atomic_flag isWriting = ATOMIC_FLAG_INIT;
    while (isWriting.test_and_set())
    {
      pause();
    }
    static const char blanks[] = "\r                                                           "
                                 "                    \r";
    if (isatty(STDIN_FILENO) || isatty(STDOUT_FILENO) || isatty(STDERR_FILENO))
    {
      WriteToStandardError(blanks, sizeof(blanks) - 1); // clears the progress line
    }
    WriteToStandardError(this->Text, this->Length + 1);
    _exit(1);
  }
};

// Signal handlers can only use a global variable.
LastLine CrashLine;
LastLine HangLine;
std::atomic<bool> IsReading{ false };
std::atomic<double> Progress{ 0.0 }; // the largest share of the current work
std::atomic<int> SecondsAllowed{ 0 };
std::atomic<int> SecondsLeft{ 0 };

std::string MakeLine(const std::string& text)
{
  return GetProgramName() + ": error: " + ToPrintable(text);
}

extern "C" void EndAfterCrash(int)
{
  CrashLine.WriteAndExit();
}

// Some readers call exit().
void EndAfterExit()
{
  if (IsReading)
  {
    CrashLine.WriteAndExit();
  }
}

int GetSeconds(const std::vector<std::string>& fileNames)
{
  double size = 0.0;
  for (const std::string& name : fileNames)
  {
    std::error_code unknown;
    const auto bytes = std::filesystem::file_size(name, unknown);
    size += unknown ? 0.0 : static_cast<double>(bytes);
  }
  return MinimumSeconds + static_cast<int>(std::min(size / 1048576.0 * SecondsPerMiB, 1e8));
}

// Reads the number after a name, or the only number, from a file of the kernel.
double ReadNumber(const char* fileName, const std::string& name)
{
  std::ifstream file(fileName);
  for (std::string word; file >> word;)
  {
    double number = 0.0;
    if (name.empty() || (word == name && file >> word))
    {
      char* end = nullptr;
      number = std::strtod(word.c_str(), &end);
      return *end == '\0' ? number : std::numeric_limits<double>::infinity();
    }
  }
  return std::numeric_limits<double>::infinity();
}

// Bytes that this process can still allocate, by the limits of machine and container.
double GetAvailableMemory()
{
  const char* const machine = "/proc/meminfo";
  const double free =
    1024.0 * (ReadNumber(machine, "MemAvailable:") + ReadNumber(machine, "SwapFree:"));
  const double container = ReadNumber("/sys/fs/cgroup/memory.max", "");
  const double used = ReadNumber("/sys/fs/cgroup/memory.current", "");
  return std::min(free, std::isfinite(used) ? std::max(container - used, 0.0) : container);
}

// Bytes of address space in use.
double GetUsedMemory()
{
  return ReadNumber("/proc/self/statm", "") * static_cast<double>(sysconf(_SC_PAGESIZE));
}
}

//------------------------------------------------------------------------------
void InstallCrashHandlers(const std::string& input)
{
  if (IsSanitized)
  {
    return; // the sanitizer's report is better
  }
  CrashLine.Set(MakeLine("the program crashed while it drew " + input +
    "; please report this, with the file and the options"));
  // The crash may be a stack overflow, so handlers need another stack.
  static char stack[65536];
  stack_t alternative = {};
  alternative.ss_sp = stack;
  alternative.ss_size = sizeof(stack);
  sigaltstack(&alternative, nullptr);
  struct sigaction action = {};
  action.sa_handler = EndAfterCrash;
  action.sa_flags = SA_ONSTACK;
  for (int signal : { SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT })
  {
    sigaction(signal, &action, nullptr);
  }
  std::set_terminate([] { std::abort(); }); // prevents the default message
  std::atexit(EndAfterExit);
}

//------------------------------------------------------------------------------
ReadingGuard::ReadingGuard(const std::vector<std::string>& fileNames)
{
  if (IsSanitized)
  {
    return;
  }
  this->Mute = std::make_unique<StandardErrorMute>();
  const std::string names = JoinWords(fileNames);
  this->OldLine = CrashLine.Get();
  CrashLine.Set(MakeLine("cannot read " + names + ": its reader crashed; the file is damaged"));
  SecondsAllowed = GetSeconds(fileNames);
  HangLine.Set(MakeLine("cannot read " + names + ": its reader made no progress for " +
    std::to_string(SecondsAllowed) + " seconds; the file is damaged"));
  RestartProgress();
  SecondsLeft = SecondsAllowed.load();
  IsReading = true;
  this->LimitMemory();
  this->Watcher = std::thread([this] { this->Watch(); });
}

//------------------------------------------------------------------------------
ReadingGuard::~ReadingGuard()
{
  if (IsSanitized)
  {
    return;
  }
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->IsDone = true;
  }
  this->Done.notify_all();
  this->Watcher.join();
  rlimit limit = {};
  getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = static_cast<rlim_t>(this->OldMemoryLimit);
  setrlimit(RLIMIT_AS, &limit);
  IsReading = false;
  CrashLine.Set(this->OldLine);
}

//------------------------------------------------------------------------------
void ReadingGuard::RestartProgress()
{
  Progress = 0.0;
}

//------------------------------------------------------------------------------
void ReadingGuard::ReportProgress(double share)
{
  if (share >= Progress + MinimumProgress)
  {
    Progress = share;
    SecondsLeft = SecondsAllowed.load();
  }
}

//------------------------------------------------------------------------------
void ReadingGuard::LimitMemory()
{
  rlimit limit = {};
  getrlimit(RLIMIT_AS, &limit);
  this->OldMemoryLimit = limit.rlim_cur;
  const double bytes = GetUsedMemory() + GetAvailableMemory();
  if (bytes < static_cast<double>(limit.rlim_cur))
  {
    limit.rlim_cur = static_cast<rlim_t>(bytes);
    setrlimit(RLIMIT_AS, &limit);
  }
}

//------------------------------------------------------------------------------
void ReadingGuard::Watch()
{
  // Counts single seconds, so that time during which the program is stopped is excluded.
  std::unique_lock<std::mutex> lock(this->Mutex);
  while (!this->Done.wait_for(lock, std::chrono::seconds(1), [this] { return this->IsDone; }))
  {
    if (--SecondsLeft <= 0)
    {
      HangLine.WriteAndExit();
    }
  }
}
