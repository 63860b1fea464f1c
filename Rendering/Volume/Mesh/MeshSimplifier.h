// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MeshSimplifier
 * @brief   a thread that simplifies meshes in the background
 *
 * The thread shares no data with the caller, who gives it the cells. All functions must be called
 * from the same thread. Private to the module.
 */
#ifndef MeshSimplifier_h
#define MeshSimplifier_h

#include "Mesh/SimplifiedMesh.h"

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

namespace relevo
{
class MeshSimplifier
{
public:
  MeshSimplifier() = default;
  /// Wait for the current step of the thread.
  ~MeshSimplifier();
  MeshSimplifier(const MeshSimplifier&) = delete;
  void operator=(const MeshSimplifier&) = delete;

  /// Simplify these cells instead of previous ones.
  void Start(std::unique_ptr<VolumeCells> cells, double share);
  /// Forget all cells and results.
  void Cancel();
  /// Return the result of the last cells, once, or null if there is none yet.
  std::unique_ptr<SimplifiedMesh> Take();
  bool IsBusy() const;

private:
  void Live();

  mutable std::mutex Mutex; // for the next four members
  std::condition_variable Changed;
  std::unique_ptr<VolumeCells> Next;
  std::unique_ptr<SimplifiedMesh> Result;
  double Share = 1.0;
  bool IsWorking = false;
  bool IsToEnd = false;
  std::atomic<bool> IsOutdated{ false }; // whether the current result is not wanted
  std::thread Thread;
};
}

#endif
