// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  PickedInput
 * @brief   gives pickers the refined surface where they ask a mapper for its input
 */
#ifndef PickedInput_h
#define PickedInput_h

#include "Picking/PickedInputPipeline.h"
#include "Picking/PickedLevels.h"   // for members
#include "Picking/PickedPolyData.h" // for members
#include "Picking/PickerDetector.h" // for members
#include "vtkSmartPointer.h"        // for members

class vtkCompositeDataSet;

namespace relevo
{
/// What a mapper keeps for pickers.
struct PickedInput
{
  PickerDetector Questions;
  RefinedSurface Surface;
  PickedLevels Levels;
  vtkNew<PickedPolyData> Data;
  vtkSmartPointer<vtkCompositeDataSet> Composite;
  vtkNew<vtkPolyData> Empty; // of what is not pickable or cannot be refined
};
}

#endif
