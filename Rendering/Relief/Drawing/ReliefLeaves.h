// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReliefLeaves
 * @brief   the reliefs of a mapper's input, each with what draws its surface and its rims
 *
 * Private to the module.
 */
#ifndef ReliefLeaves_h
#define ReliefLeaves_h

#include "Changes/Dependencies.h"
#include "Composite/LeafMapper.h"
#include "Data/Reliefs.h"
#include "Drawing/ReliefPainter.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkStructuredGrid.h"

#include <functional>
#include <string>
#include <vector>

class vtkBoundingBox;
class vtkDataObject;

namespace relevo
{
struct ReliefLeaf
{
  using Painter = ReliefPainter;
  std::vector<ReliefPainter*> GetPainters() const;

  ReliefBlock Relief;
  vtkSmartPointer<ReliefPainter> Surface; // nullptr of what never was a relief
  vtkSmartPointer<ReliefPainter> Rims;    // nullptr for none
  Dependencies Source;
  std::string Error;                         // reported last
  std::string ShaderError;                   // likewise
  vtkSmartPointer<vtkStructuredGrid> Picked; // the surface, when a picker has asked for it
};

class ReliefLeaves : public LeafMapper<ReliefLeaf>
{
public:
  struct Settings
  {
    double MaximumStretch = 0.0;
    bool HasRims = false;
  };

  /// Read the input again if it has changed. Blocks that are no reliefs are reported once.
  void Update(vtkDataObject* input, const Settings& settings, vtkWindow* window,
    const std::function<void(const std::string&)>& report);

  void AddBounds(vtkBoundingBox& box);
  bool AreTranslucent();
  /// That REFINEMENT draws of all reliefs.
  double CountTriangles();

  /// What pickers intersect: the surface, or all of them; nothing where none is drawn.
  vtkDataObject* GetPicked(vtkDataObject* input);

private:
  void UpdateRims(vtkWindow* window);
  vtkStructuredGrid* GetPickedSurface(unsigned int flatIndex);

  Dependencies Source;
  Dependencies RimDependencies;
  Settings Current;
  vtkSmartPointer<vtkDataObject> PickedBlocks;
  vtkNew<vtkStructuredGrid> NoSurface;
};
}

#endif
