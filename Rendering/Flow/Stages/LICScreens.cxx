// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages/LICScreens.h"

#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace relevo
{
namespace
{
constexpr size_t MaximumScreens = 8;
}

LICScreen& LICScreens::Get(vtkRenderer* ren, vtkActor* act)
{
  LICScreen& screen = this->Screens[Key(ren, act, ren->GetActiveCamera())];
  screen.LastUse = ++this->Use;
  while (this->Screens.size() > MaximumScreens)
  {
    auto oldest = std::min_element(this->Screens.begin(), this->Screens.end(),
      [](const auto& a, const auto& b) { return a.second.LastUse < b.second.LastUse; });
    oldest->second.ReleaseGraphicsResources(ren->GetRenderWindow());
    this->Screens.erase(oldest);
  }
  return screen;
}

LICScreen* LICScreens::Find(vtkRenderer* ren, vtkActor* act)
{
  const auto screen = this->Screens.find(Key(ren, act, ren->GetActiveCamera()));
  const bool hasImage = screen != this->Screens.end() && !screen->second.Sources.IsEmpty();
  return hasImage ? &screen->second : nullptr;
}

vtkTypeInt64 LICScreens::GetMemorySize() const
{
  vtkTypeInt64 size = 0;
  for (const auto& screen : this->Screens)
  {
    size += screen.second.GetMemorySize();
  }
  return size;
}

void LICScreens::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto& screen : this->Screens)
  {
    screen.second.ReleaseGraphicsResources(window);
  }
  this->Screens.clear();
}
}
