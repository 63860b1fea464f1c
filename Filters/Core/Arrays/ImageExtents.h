// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   what filters of flat images tell the pipeline
 *
 * Private to Relevo's own sources.
 */
#ifndef ImageExtents_h
#define ImageExtents_h

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace relevo
{
/// An output of width x height x 1 points, the first at the origin, 1 apart.
inline void SetImageSize(vtkInformation* output, int width, int height)
{
  const int extent[6] = { 0, width - 1, 0, height - 1, 0, 0 };
  const double origin[3] = { 0.0, 0.0, 0.0 };
  const double spacing[3] = { 1.0, 1.0, 1.0 };
  output->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  output->Set(vtkDataObject::ORIGIN(), origin, 3);
  output->Set(vtkDataObject::SPACING(), spacing, 3);
}

/// Of an input, which may be nullptr, all that it has.
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
