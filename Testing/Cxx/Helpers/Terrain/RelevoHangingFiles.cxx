// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoHangingFiles.h"

#include <cpl_vsi.h>

#include <condition_variable>
#include <mutex>

namespace
{
struct Gate
{
  std::mutex Mutex; // protects the next members
  std::condition_variable Changed;
  bool IsClosed = false;
  int Hanging = 0;
  int OpenFiles = 0;
};

// Threads that read can outlive static objects.
Gate& GetGate()
{
  static Gate* gate = new Gate;
  return *gate;
}

VSILFILE* GetStream(void* file)
{
  return static_cast<VSILFILE*>(file);
}

void* OpenFile(void*, const char* name, const char* access)
{
  VSILFILE* file = VSIFOpenL(name, access);
  const std::lock_guard<std::mutex> lock(GetGate().Mutex);
  GetGate().OpenFiles += file ? 1 : 0;
  return file;
}

size_t ReadFile(void* file, void* bytes, size_t size, size_t count)
{
  Gate& gate = GetGate();
  std::unique_lock<std::mutex> lock(gate.Mutex);
  ++gate.Hanging;
  gate.Changed.notify_all();
  gate.Changed.wait(lock, [&gate] { return !gate.IsClosed; });
  --gate.Hanging;
  lock.unlock();
  return VSIFReadL(bytes, size, count, GetStream(file));
}

int CloseFile(void* file)
{
  const int result = VSIFCloseL(GetStream(file));
  const std::lock_guard<std::mutex> lock(GetGate().Mutex);
  --GetGate().OpenFiles;
  GetGate().Changed.notify_all();
  return result;
}

void SetClosed(bool isClosed)
{
  const std::lock_guard<std::mutex> lock(GetGate().Mutex);
  GetGate().IsClosed = isClosed;
  GetGate().Changed.notify_all();
}
}

const char* const RelevoHangingFiles::Prefix = "/vsirelevohanging/";

void RelevoHangingFiles::Install()
{
  static const bool isInstalled = []
  {
    VSIFilesystemPluginCallbacksStruct* calls = VSIAllocFilesystemPluginCallbacksStruct();
    calls->open = &OpenFile;
    calls->stat = [](void*, const char* name, VSIStatBufL* status, int) -> int
    { return VSIStatL(name, status); };
    calls->tell = [](void* file) { return VSIFTellL(GetStream(file)); };
    calls->seek = [](void* file, vsi_l_offset offset, int origin)
    { return VSIFSeekL(GetStream(file), offset, origin); };
    calls->read = &ReadFile;
    calls->eof = [](void* file) { return VSIFEofL(GetStream(file)); };
    calls->close = &CloseFile;
    VSIInstallPluginHandler(Prefix, calls);
    VSIFreeFilesystemPluginCallbacksStruct(calls);
    return true;
  }();
  static_cast<void>(isInstalled);
}

void RelevoHangingFiles::Hang()
{
  SetClosed(true);
}

void RelevoHangingFiles::Resume()
{
  SetClosed(false);
}

int RelevoHangingFiles::GetNumberOfHanging()
{
  const std::lock_guard<std::mutex> lock(GetGate().Mutex);
  return GetGate().IsClosed ? GetGate().Hanging : 0;
}

void RelevoHangingFiles::WaitForHanging()
{
  Gate& gate = GetGate();
  std::unique_lock<std::mutex> lock(gate.Mutex);
  gate.Changed.wait(lock, [&gate] { return gate.IsClosed && gate.Hanging > 0; });
}

void RelevoHangingFiles::WaitForClosed()
{
  Gate& gate = GetGate();
  std::unique_lock<std::mutex> lock(gate.Mutex);
  gate.Changed.wait(lock, [&gate] { return gate.OpenFiles == 0; });
}
