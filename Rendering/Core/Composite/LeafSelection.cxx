// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Composite/LeafSelection.h"

#include "vtkHardwareSelector.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace relevo
{
LeafSelection::LeafSelection(vtkRenderer* renderer)
  : Selector(renderer->GetSelector())
{
  if (this->Selector)
  {
    this->Selector->BeginRenderProp();
  }
}

LeafSelection::~LeafSelection()
{
  if (this->Selector)
  {
    this->Selector->EndRenderProp();
  }
}

void LeafSelection::Begin(unsigned int flatIndex)
{
  if (this->Selector &&
    this->Selector->GetCurrentPass() == vtkHardwareSelector::COMPOSITE_INDEX_PASS)
  {
    // An input that is not composite has VTK's index of a single block.
    this->Selector->RenderCompositeIndex(std::max(flatIndex, 1u));
  }
}
}
