// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Tests of vtkAdaptiveRefinementMapper run again with RELEVO_TEST_LIC=1: a vtkAdaptiveLICMapper
// whose LIC has no share in the colours has to pass them, too.
#include "RelevoLICVectors.h"

#include <cstdlib>

namespace
{
const bool IsInstalled = []()
{
  if (std::getenv("RELEVO_TEST_LIC"))
  {
    RelevoScene::NewMapper = RelevoLICVectors::NewInvisible;
  }
  return true;
}();
}
