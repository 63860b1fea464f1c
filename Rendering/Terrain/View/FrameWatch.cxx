// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "View/FrameWatch.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace relevo
{
FrameWatch::FrameWatch()
{
  this->Command->SetClientData(this);
  this->Command->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      for (Entry& entry : static_cast<FrameWatch*>(data)->Entries)
      {
        entry.HasBegun = entry.HasBegun || entry.Renderer == caller;
      }
    });
}

FrameWatch::~FrameWatch()
{
  for (const Entry& entry : this->Entries)
  {
    if (entry.Renderer)
    {
      entry.Renderer->RemoveObserver(entry.Tag);
    }
  }
}

bool FrameWatch::IsNewFrame(vtkRenderer* renderer)
{
  this->Entries.erase(std::remove_if(this->Entries.begin(), this->Entries.end(),
                        [](const Entry& entry) { return entry.Renderer == nullptr; }),
    this->Entries.end());
  const auto found = std::find_if(this->Entries.begin(), this->Entries.end(),
    [renderer](const Entry& entry) { return entry.Renderer == renderer; });
  if (found == this->Entries.end())
  {
    Entry entry;
    entry.Renderer = renderer;
    entry.Tag = renderer->AddObserver(vtkCommand::StartEvent, this->Command);
    this->Entries.push_back(entry);
    return true;
  }
  const bool hasBegun = found->HasBegun;
  found->HasBegun = false;
  return hasBegun;
}
}
