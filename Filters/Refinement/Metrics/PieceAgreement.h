// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   exchanges values of the whole surface between its pieces, one on each process
 *
 * The functions are collective: all processes call them in the same order.
 */
#ifndef PieceAgreement_h
#define PieceAgreement_h

#include "RelevoFiltersRefinementModule.h" // for export macro

#include <functional> // for what prepares a piece

class vtkDepthTagMetric;
class vtkMultiProcessController;
class vtkPolyData;

namespace relevo
{
struct RefinementView;
struct GlobalSurfaceInfo;
class PieceReduction;
class MetricCache;

/// Exchange the values for preparing a piece: the box of all points.
RELEVOFILTERSREFINEMENT_EXPORT void AgreeOnPoints(
  vtkPolyData* piece, const PieceReduction& pieces, GlobalSurfaceInfo& whole);

/**
 * Exchange the values for selecting levels. The piece is prepared or empty. The metric may be
 * nullptr. whole.HasDirections is the piece's value on input, and true on output if it is true for
 * a piece.
 */
RELEVOFILTERSREFINEMENT_EXPORT void AgreeOnShape(vtkPolyData* piece, MetricCache& source,
  vtkDepthTagMetric* metric, const RefinementView& view, const PieceReduction& pieces,
  GlobalSurfaceInfo& whole);

/**
 * Call both functions for a filter, and `prepare` in between, with the values for preparing the
 * piece, or nullptr if there are no other processes. `prepare` sets HasDirections and returns
 * whether the piece is valid. Sets the whole surface of `source` and returns the result of
 * `prepare`.
 */
RELEVOFILTERSREFINEMENT_EXPORT bool AgreeOnPiece(vtkMultiProcessController* controller,
  vtkPolyData* piece, MetricCache& source, vtkDepthTagMetric* metric, const RefinementView& view,
  const std::function<bool(GlobalSurfaceInfo*)>& prepare);
}

#endif
