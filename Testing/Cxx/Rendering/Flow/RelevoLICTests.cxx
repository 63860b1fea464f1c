// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Runs tests of vtkAdaptiveRefinementMapper again if RELEVO_TEST_LIC=1, with a vtkAdaptiveLICMapper
// whose LIC does not contribute to the colours.
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
