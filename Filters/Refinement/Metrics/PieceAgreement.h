// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   what pieces of a surface, one on each process, must know of the whole
 *
 * Collective: all processes call the same functions in the same order.
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

/// What a piece is prepared by: the box of all points.
RELEVOFILTERSREFINEMENT_EXPORT void AgreeOnPoints(
  vtkPolyData* piece, const PieceReduction& pieces, GlobalSurfaceInfo& whole);

/**
 * What levels are chosen by, of a piece that is prepared or is empty. The metric may be nullptr.
 * whole.HasDirections is that of the piece before, and of any of them afterwards.
 */
RELEVOFILTERSREFINEMENT_EXPORT void AgreeOnShape(vtkPolyData* piece, MetricCache& source,
  vtkDepthTagMetric* metric, const RefinementView& view, const PieceReduction& pieces,
  GlobalSurfaceInfo& whole);

/**
 * Both, for a filter: `prepare` is called in between, with what the piece is prepared by, nullptr
 * where there are no other processes; it sets HasDirections and returns whether the piece is valid.
 * Tells the source, and returns what `prepare` did.
 */
RELEVOFILTERSREFINEMENT_EXPORT bool AgreeOnPiece(vtkMultiProcessController* controller,
  vtkPolyData* piece, MetricCache& source, vtkDepthTagMetric* metric, const RefinementView& view,
  const std::function<bool(GlobalSurfaceInfo*)>& prepare);
}

#endif
