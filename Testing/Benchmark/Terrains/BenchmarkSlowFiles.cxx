// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkSlowFiles.h"

#include <cpl_vsi.h>

#include <atomic>
#include <chrono>
#include <string>
#include <thread>

namespace
{
std::atomic<int> ReadDelay{ 0 };

VSILFILE* GetFile(void* file)
{
  return static_cast<VSILFILE*>(file);
}
}

const char* const BenchmarkSlowFiles::Prefix = "/vsirelevoslow/";

void BenchmarkSlowFiles::Install()
{
  VSIFilesystemPluginCallbacksStruct* calls = VSIAllocFilesystemPluginCallbacksStruct();
  calls->open = [](void*, const char* name, const char* access) -> void*
  { return VSIFOpenL(name, access); };
  calls->stat = [](void*, const char* name, VSIStatBufL* status, int) -> int
  { return VSIStatL(name, status); };
  calls->tell = [](void* file) { return VSIFTellL(GetFile(file)); };
  calls->seek = [](void* file, vsi_l_offset offset, int origin)
  { return VSIFSeekL(GetFile(file), offset, origin); };
  calls->read = [](void* file, void* bytes, size_t size, size_t count)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(ReadDelay));
    return VSIFReadL(bytes, size, count, GetFile(file));
  };
  calls->eof = [](void* file) { return VSIFEofL(GetFile(file)); };
  calls->close = [](void* file) { return VSIFCloseL(GetFile(file)); };
  VSIInstallPluginHandler(Prefix, calls);
  VSIFreeFilesystemPluginCallbacksStruct(calls);
}

void BenchmarkSlowFiles::SetDelay(int milliseconds)
{
  ReadDelay = milliseconds;
}
