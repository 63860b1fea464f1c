// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  PickedInput
 * @brief   gives pickers the refined surface where they ask a mapper for its input
 */
#ifndef PickedInput_h
#define PickedInput_h

#include "Picking/PickedLevels.h"    // for members
#include "Picking/PickedPolyData.h"  // for members
#include "Picking/PickerQuestions.h" // for members
#include "vtkCompositeDataPipeline.h"
#include "vtkSmartPointer.h" // for members

#include <functional> // for members

class vtkCompositeDataSet;

namespace relevo
{
/// The executive of a mapper: what its input is depends on who asks.
class PickedInputPipeline : public vtkCompositeDataPipeline
{
public:
  static PickedInputPipeline* New();

  /// Called with the input and gives what to tell instead; for as long as there is an algorithm.
  std::function<vtkDataObject*(vtkDataObject*)> Replace;

  using vtkCompositeDataPipeline::GetInputData;
  vtkDataObject* GetInputData(int port, int connection) override;
};

/// What a mapper keeps for pickers.
struct PickedInput
{
  PickerQuestions Questions;
  RefinedSurface Surface;
  PickedLevels Levels;
  vtkNew<PickedPolyData> Data;
  vtkSmartPointer<vtkCompositeDataSet> Composite;
  vtkNew<vtkPolyData> Empty; // of what is not pickable or cannot be refined
};
}

#endif
