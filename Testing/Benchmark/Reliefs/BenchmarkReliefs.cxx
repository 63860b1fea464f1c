// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Reliefs: how fast they are warped.
#include "BenchmarkWarps.h"

void RunReliefs(const BenchmarkOptions& options, const AddTable& addTable)
{
  AddWarps(options, addTable);
}
