// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that random calls of vtkAdaptiveRefinementMapper and of VTK's classes around a mapper,
// with random inputs, never crash, and that the mapper's counters stay consistent.
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
