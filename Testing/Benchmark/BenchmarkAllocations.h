// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   memory that C++ code of this process allocates with new
 *
 * Unlike the resident memory of the process, it does not include the buffers of a software renderer
 * and of OpenGL drivers, nor VTK's arrays, which are allocated with malloc().
 */
#ifndef BenchmarkAllocations_h
#define BenchmarkAllocations_h

struct AllocatedMemory
{
  double Current = 0.0; // bytes; negative if older memory has been freed
  double Peak = 0.0;
};
/// Call this once, before GetAllocatedMemory(). Counting takes time.
void CountAllocatedMemory();
/// Return the memory since CountAllocatedMemory(). NaN on systems other than Linux.
AllocatedMemory GetAllocatedMemory();

#endif
