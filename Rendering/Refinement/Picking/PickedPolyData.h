// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PickedPolyData
 * @brief   the data that VTK's pickers get instead of a mapper's input
 *
 * It has the input's cells and arrays. After Ask() it answers the calls of one picker as if it were
 * the refined surface:
 *
 * - vtkCellPicker intersects the line with cell after cell. The first call for a face computes the
 *   intersection of the line and the refined surface. This is returned when its coarse cell is
 *   tested; all other cells return none. Until then the data set is not a vtkPolyData, because
 *   vtkCellPicker clips the line by clipping planes only for other data sets. Finally, the picker
 *   computes weights and a normal from the coarse cell, which is rotated to the normal of the
 *   refined surface. To make it do so, normals are not an active attribute here.
 * - vtkPointPicker first requests the number of points, and then gets their positions on the
 *   refined surface.
 *
 * Afterwards it is an ordinary vtkPolyData. Private to the module.
 */
#ifndef PickedPolyData_h
#define PickedPolyData_h

#include "Changes/Dependencies.h"        // for members
#include "Intersection/RefinedSurface.h" // for members
#include "vtkNew.h"                      // for members
#include "vtkPolyData.h"
#include "vtkSmartPointer.h" // for members

class vtkPoints;

namespace relevo
{
class PatternSelection;
class RefinementMesh;

/// The surface to pick. All members must outlive the picker's calls.
struct PickedSurface
{
  vtkPolyData* Input;
  const RefinementMesh* Mesh;
  const RefinedSurface* Surface;
  const PatternSelection* Selection;
  double Bounds[6];
};

class PickedPolyData : public vtkPolyData
{
public:
  static PickedPolyData* New();

  /// Take copies the cells, arrays and bounds of a surface; Ask prepares for the calls of a picker.
  void Take(const PickedSurface& surface);
  void Ask();

  /// Return a cell's intersection with the line of a picker. The cells given to pickers call it.
  int Answer(const double start[3], const double end[3], double tolerance, double& t,
    double position[3], double pcoords[3], int& subId);

  vtkTypeBool IsA(const char* type) override;
  int GetCellType(vtkIdType cellId) override;
  using vtkPolyData::GetCell;
  using vtkPolyData::GetCellPoints;
  void GetCellPoints(vtkIdType cellId, vtkIdList* points) override;
  void GetCell(vtkIdType cellId, vtkGenericCell* cell) override;
  vtkIdType GetNumberOfPoints() override;
  void ComputeBounds() override;

protected:
  PickedPolyData();
  ~PickedPolyData() override;

private:
  enum States
  {
    NOT_ASKED,
    ASKED,
    HIT_KNOWN, // until the picker has tested all cells
    ALL_TRIED,
    POINTS_MOVED
  };
  class FaceCell;

  void Synchronize(vtkPolyData* input);
  bool IsFace(vtkIdType cellId) { return cellId >= this->FirstFaceCell; }
  void EndCell();
  void MovePoints();

  States State = NOT_ASKED;
  PickedSurface Asked{};
  vtkIdType FirstFaceCell = 0;
  vtkIdType LastCell = -1;
  vtkIdType CellId = -1; // of the face being tested
  vtkIdType HitCellId = -1;
  SurfaceHit Hit;
  vtkNew<vtkGenericCell> HitCell; // rotated cell
  int HitSubId = 0;
  double HitPCoords[3] = { 0.0, 0.0, 0.0 };
  Dependencies SourceDependencies;
  vtkNew<vtkPoints> MovedPoints;
  Dependencies MovedDependencies;
  vtkSmartPointer<FaceCell> Face;
};
}

#endif
