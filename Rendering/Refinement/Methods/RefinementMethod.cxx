// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Methods/RefinementMethod.h"

#include "Buffers/BufferTexture.h"
#include "Buffers/InstanceBuffers.h"
#include "State/ViewSelection.h"

namespace relevo
{
RefinementMethod::RefinementMethod() = default;
RefinementMethod::~RefinementMethod() = default;

bool RefinementMethod::UploadInstances(const RefinementDrawing& drawing)
{
  const ViewSelection& selection = *drawing.Selection;
  const PatternSelection& patterns = selection.GetSelection();
  return drawing.Instances->Upload(
           drawing.Window, drawing.Slot, patterns.Instances, selection.GetGroupsTime()) &&
    drawing.Instances->UploadMorphTags(
      drawing.Window, patterns.GetMorphTags(), selection.GetLevelsTime());
}

bool RefinementMethod::FailForSize()
{
  this->Error = BufferTexture::GetTooLarge();
  return false;
}

const char* RefinementMethod::GetName(int method)
{
  static const char* const names[] = { "ARKFPI", "ARK", "DMR", "SUAPT", "HardwareTessellation",
    "Uniform" };
  return names[method];
}
}
