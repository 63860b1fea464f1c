// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PickedInput
 * @brief   gives pickers the refined surface where they ask a mapper for its input
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
    /// With a valid mesh.
    RefinementState* State;
    /// How the method in use draws levels.
    PickedLevels::Kinds Kind;
  };
  /**
   * The refined surface; empty where the recipe cannot be applied. `isAsked` says that a picker
   * intersects it next.
   */
  vtkPolyData* Get(const Source& source, bool isAsked);

  /// What cannot be picked.
  vtkPolyData* GetEmpty() { return this->Empty; }

  /// A composite data set with getLeaf(flat index) in place of its leaves.
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
