// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/PieceAgreement.h"

#include "Metrics/MetricCache.h"
#include "Metrics/MetricEvaluator.h"
#include "Metrics/SurfaceShape.h"
#include "Parallel/GlobalSurfaceInfo.h"
#include "Parallel/ProcessReduction.h"
#include "Points/LocalPoints.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <memory>
#include <vector>

namespace relevo
{
namespace
{
// Extends the box of a piece to that of the whole surface.
void Unite(FiniteBox& box, const PieceReduction& pieces)
{
  std::vector<double> limits;
  for (int axis = 0; axis < 3; ++axis)
  {
    limits.insert(limits.end(), { -box.Low[axis], box.High[axis] });
  }
  pieces.TakeLargest(limits);
  for (int axis = 0; axis < 3; ++axis)
  {
    box.Low[axis] = -limits[2 * axis];
    box.High[axis] = limits[2 * axis + 1];
  }
}
}

void AgreeOnPoints(vtkPolyData* piece, const PieceReduction& pieces, GlobalSurfaceInfo& whole)
{
  whole.PointBox = MeasurePoints(piece->GetPoints());
  Unite(whole.PointBox, pieces);
}

void AgreeOnShape(vtkPolyData* piece, MetricCache& source, vtkDepthTagMetric* metric,
  const RefinementView& view, const PieceReduction& pieces, GlobalSurfaceInfo& whole)
{
  std::vector<double> directions(1, whole.HasDirections ? 1.0 : 0.0);
  pieces.TakeLargest(directions);
  whole.HasDirections = directions[0] > 0.0;
  whole.CornerBox = GetShape(source.GetMesh(piece)).GetOwnBoxes().CornerBox;
  Unite(whole.CornerBox, pieces);
  whole.Numbers.clear();
  if (metric)
  {
    source.GetEvaluator(metric, piece).ShareNumbers(view, pieces, whole);
  }
}

bool AgreeOnPiece(vtkMultiProcessController* controller, vtkPolyData* piece, MetricCache& source,
  vtkDepthTagMetric* metric, const RefinementView& view,
  const std::function<bool(GlobalSurfaceInfo*)>& prepare)
{
  if (!controller || controller->GetNumberOfProcesses() < 2)
  {
    source.SetWhole(nullptr);
    return prepare(nullptr);
  }
  const ProcessReduction pieces(controller);
  GlobalSurfaceInfo whole;
  if (source.GetWhole())
  {
    whole = *source.GetWhole();
  }
  whole.HasDirections = false;
  AgreeOnPoints(piece, pieces, whole);
  source.SetWhole(std::make_shared<GlobalSurfaceInfo>(whole));

  bool valid = prepare(&whole);
  const bool hasDirections = whole.HasDirections;
  vtkNew<vtkPolyData> empty;
  MetricCache none; // the cache of an invalid mesh must not be used
  AgreeOnShape(valid ? piece : empty.Get(), valid ? source : none, metric, view, pieces, whole);
  source.SetWhole(std::make_shared<GlobalSurfaceInfo>(whole));
  if (valid && whole.HasDirections != hasDirections)
  {
    valid = prepare(&whole);
  }
  return valid;
}
}
