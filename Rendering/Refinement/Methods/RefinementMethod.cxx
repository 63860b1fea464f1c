// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Methods/RefinementMethod.h"

#include "Buffers/BufferTexture.h"
#include "Buffers/InstanceBuffers.h"
#include "Methods/ARKFPIMethod.h"
#include "Methods/ARKMethod.h"
#include "Methods/DMRMethod.h"
#include "Methods/HardwareTessellation.h"
#include "Methods/SUAPTMethod.h"
#include "Methods/UniformMethod.h"
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

std::unique_ptr<RefinementMethod> RefinementMethod::New(int method)
{
  switch (method)
  {
    case ARK:
      return std::unique_ptr<RefinementMethod>(new ARKMethod);
    case DMR:
      return std::unique_ptr<RefinementMethod>(new DMRMethod);
    case SUAPT:
      return std::unique_ptr<RefinementMethod>(new SUAPTMethod);
    case HARDWARE_TESSELLATION:
      return std::unique_ptr<RefinementMethod>(new HardwareTessellation);
    case UNIFORM:
      return std::unique_ptr<RefinementMethod>(new UniformMethod);
    default:
      return std::unique_ptr<RefinementMethod>(new ARKFPIMethod);
  }
}

const char* RefinementMethod::GetName(int method)
{
  static const char* const names[] = { "ARKFPI", "ARK", "DMR", "SUAPT", "HardwareTessellation",
    "Uniform" };
  return names[method];
}
}
