// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Options/ProgramRun.h"

#include "Options/UsageError.h"
#include "Text/StandardError.h"

#include <exception>
#include <new>

namespace
{
enum ExitCode
{
  Success = 0,
  BadInput = 1,
  BadUsage = 2
};
}

//------------------------------------------------------------------------------
int RunProgram(const std::string& name, const std::function<void()>& run)
{
  SetProgramName(name);
  try
  {
    run();
    return Success;
  }
  catch (const UsageError& error)
  {
    WriteMessage("error", std::string(error.what()) + " (see " + name + " --help)");
    return BadUsage;
  }
  catch (const std::bad_alloc&)
  {
    WriteMessage("error", "not enough memory");
    return BadInput;
  }
  catch (const std::exception& error)
  {
    WriteMessage("error", error.what());
    return BadInput;
  }
}
