// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   pipeline information for filters of 2D images
 */
#ifndef ImageExtents_h
#define ImageExtents_h

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace relevo
{
/// Set the output to width x height x 1 points, with the first point at the origin and spacing 1.
inline void SetImageSize(vtkInformation* output, int width, int height)
{
  const int extent[6] = { 0, width - 1, 0, height - 1, 0, 0 };
  const double origin[3] = { 0.0, 0.0, 0.0 };
  const double spacing[3] = { 1.0, 1.0, 1.0 };
  output->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  output->Set(vtkDataObject::ORIGIN(), origin, 3);
  output->Set(vtkDataObject::SPACING(), spacing, 3);
}

/// Request the whole extent of an input, which may be nullptr.
inline void RequestWholeExtent(vtkInformation* input)
{
  if (input && input->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
  {
    input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(),
      input->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()), 6);
  }
}
}

#endif
