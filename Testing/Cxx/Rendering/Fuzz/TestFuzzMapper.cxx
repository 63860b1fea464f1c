// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkAdaptiveRefinementMapper and what VTK has around a mapper, called in random order on random
// inputs: nothing crashes, and what the mapper says of itself makes sense.
#include "RelevoCheck.h"
#include "RelevoFuzzMapper.h"

int TestFuzzMapper(int, char*[])
{
  RelevoCheck check;
  int calls = 0;
  CHECK_EQUAL(
    RelevoFuzz::Run<RelevoFuzz::MapperMachine<vtkAdaptiveRefinementMapper>>(20, 60, calls), 0);
  std::cout << calls << " calls\n";
  return check.GetResult();
}
