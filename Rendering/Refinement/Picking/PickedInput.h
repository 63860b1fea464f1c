// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PickedInput
 * @brief   gives pickers the refined surface when they request a mapper's input
 *
 * Private to the module.
 */
#ifndef PickedInput_h
#define PickedInput_h

#include "Picking/PickedLevels.h"   // for members
#include "Picking/PickedPolyData.h" // for members
#include "Picking/PickerDetector.h" // for members
#include "vtkNew.h"                 // for members
#include "vtkSmartPointer.h"        // for members

#include <functional> // for GetComposite()

class vtkAdaptiveRefinement;
class vtkCompositeDataSet;
class vtkDataObject;
class vtkPolyData;

namespace relevo
{
class RefinementState;

class PickedInput
{
public:
  PickedInput();
  ~PickedInput();

  PickerDetector& GetDetector() { return this->Detector; }

  struct Source
  {
    vtkPolyData* Input;
    vtkAdaptiveRefinement* Recipe;
    /// The state with a valid mesh.
    RefinementState* State;
    /// How the current method draws levels.
    PickedLevels::Kinds Kind;
  };
  /**
   * Return the refined surface; it is empty if the recipe cannot be applied. `isAsked` means that a
   * picker intersects it next.
   */
  vtkPolyData* Get(const Source& source, bool isAsked);

  /// Return a surface that cannot be picked.
  vtkPolyData* GetEmpty() { return this->Empty; }

  /// Return a composite data set with getLeaf(flat index) instead of its leaves.
  vtkDataObject* GetComposite(
    vtkCompositeDataSet* input, const std::function<vtkPolyData*(unsigned int)>& getLeaf);

private:
  PickerDetector Detector;
  RefinedSurface Surface;
  PickedLevels Levels;
  vtkNew<PickedPolyData> Data;
  vtkSmartPointer<vtkCompositeDataSet> Composite;
  vtkNew<vtkPolyData> Empty;
};
}

#endif
