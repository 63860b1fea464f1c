// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   moving objects in a vtkContactScene: its share of the frame time
 */
#ifndef BenchmarkContacts_h
#define BenchmarkContacts_h

#include "Benchmarks.h"

void AddContacts(const BenchmarkOptions& options, const AddTable& addTable);

#endif
