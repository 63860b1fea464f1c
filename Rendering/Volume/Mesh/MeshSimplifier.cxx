// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/MeshSimplifier.h"

#include "Cells/VolumeCells.h"

#include <new>
#include <utility>

namespace relevo
{
MeshSimplifier::~MeshSimplifier()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->IsToEnd = true;
    this->IsOutdated = true;
  }
  this->Changed.notify_all();
  if (this->Thread.joinable())
  {
    this->Thread.join();
  }
}

void MeshSimplifier::Start(std::unique_ptr<VolumeCells> cells, double share)
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Next = std::move(cells);
    this->Share = share;
    this->Result.reset();
    this->IsOutdated = true;
  }
  if (!this->Thread.joinable())
  {
    this->Thread = std::thread([this] { this->Live(); });
  }
  this->Changed.notify_all();
}

void MeshSimplifier::Cancel()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Next.reset();
  this->Result.reset();
  this->IsOutdated = true;
}

std::unique_ptr<SimplifiedMesh> MeshSimplifier::Take()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return std::move(this->Result);
}

bool MeshSimplifier::IsBusy() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Next || (this->IsWorking && !this->IsOutdated);
}

void MeshSimplifier::Live()
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  while (true)
  {
    this->Changed.wait(lock, [this] { return this->IsToEnd || this->Next; });
    if (this->IsToEnd)
    {
      return;
    }
    std::unique_ptr<VolumeCells> cells = std::move(this->Next);
    const double share = this->Share;
    this->IsOutdated = false;
    this->IsWorking = true;
    lock.unlock();
    auto result = std::make_unique<SimplifiedMesh>();
    try
    {
      *result = SimplifiedMesh::Make(*cells, share, this->IsOutdated);
    }
    catch (const std::bad_alloc&) // the full mesh is drawn
    {
      *result = SimplifiedMesh();
    }
    cells.reset();
    lock.lock();
    this->IsWorking = false;
    if (!this->IsOutdated)
    {
      this->Result = std::move(result);
    }
  }
}
}
