// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PickedPolyData
 * @brief   what VTK's pickers see of a mapper in place of its input
 *
 * Has the input's cells and arrays. After Ask() it answers the questions of one picker as if it
 * were the refined surface:
 *
 * - vtkCellPicker tries the line on cell after cell. The first face that is asked for finds where
 *   the line meets the refined surface, and hands the answer out when its coarse cell has its turn;
 *   all others are empty. Until then this is no vtkPolyData, as of other data sets vtkCellPicker
 *   tries only what clipping planes leave of a line. The cell that it takes in the end to compute
 *   weights and a normal from is the coarse one, turned to face as the refined surface does; for
 *   that, normals are not an active attribute here.
 * - vtkPointPicker counts the points first, and then sees them where the refined surface has them.
 *
 * After that it is like any other vtkPolyData. Private to the module.
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

/// What is asked; all must outlive the picker's questions.
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

  /// Have the cells, arrays and bounds of a surface; be ready for the questions of a picker.
  void Take(const PickedSurface& surface);
  void Ask();

  /// The answer that a face's cell gives to the line of a picker. Used by the cells handed out.
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
    HIT_KNOWN, // until the picker has been through all cells
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
  vtkIdType CellId = -1; // the face's that is asked
  vtkIdType HitCellId = -1;
  SurfaceHit Hit;
  vtkNew<vtkGenericCell> HitCell; // turned
  int HitSubId = 0;
  double HitPCoords[3] = { 0.0, 0.0, 0.0 };
  Dependencies SourceDependencies;
  vtkNew<vtkPoints> MovedPoints;
  Dependencies MovedDependencies;
  vtkSmartPointer<FaceCell> Face;
};
}

#endif
