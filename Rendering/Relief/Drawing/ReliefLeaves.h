// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReliefLeaves
 * @brief   the reliefs of a mapper's input, with the painters of their surfaces and rims
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
  vtkSmartPointer<ReliefPainter> Surface; // nullptr before there was a valid relief
  vtkSmartPointer<ReliefPainter> Rims;    // nullptr for none
  Dependencies Source;
  std::string Error;                         // reported last
  std::string ShaderError;                   // reported last
  vtkSmartPointer<vtkStructuredGrid> Picked; // the surface, after a picker has requested it
};

class ReliefLeaves : public LeafMapper<ReliefLeaf>
{
public:
  struct Settings
  {
    double MaximumStretch = 0.0;
    bool HasRims = false;
  };

  /// Update the reliefs if the input has changed. Blocks that are not reliefs are reported once.
  void Update(vtkDataObject* input, const Settings& settings, vtkWindow* window,
    const std::function<void(const std::string&)>& report);

  void AddBounds(vtkBoundingBox& box);
  bool AreTranslucent();
  /// Return the number of triangles that REFINEMENT draws for all reliefs.
  double CountTriangles();

  /// Return the data that pickers intersect: the surface or surfaces, or an empty one if nothing is
  /// drawn.
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
