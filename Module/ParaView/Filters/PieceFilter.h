// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PieceFilter
 * @brief   applies a filter for one surface to pieces that are distributed over several processes
 *
 * The input is a vtkPolyData or a tree of data sets, and so is the output.
 *
 * Private to the module.
 */
#ifndef PieceFilter_h
#define PieceFilter_h

#include "SurfacePieces.h" // for members

#include <functional> // for what is called

class vtkAlgorithm;
class vtkDataObject;
class vtkInformation;
class vtkInformationVector;
class vtkMultiProcessController;
class vtkPolyData;

namespace relevo
{
class PieceFilter
{
public:
  /// A cell array of a piece: the ids of the input's cells.
  static constexpr const char* CellIds = "relevo::CellIds";

  static void FillInput(vtkInformation* info);
  static void FillOutput(vtkInformation* info);
  /// Create an output of the input's type.
  static bool MakeOutput(vtkInformationVector** inputVector, vtkInformationVector* outputVector);

  /**
   * Computes the output of a piece, which has ghosts and the array CellIds, and is sorted: see
   * SurfacePieces. `own` is the piece as in the input, except for ghosts of other processes. It is
   * nullptr if this process has none and only takes part in collective calls.
   */
  using Work = std::function<void(vtkPolyData* own, vtkPolyData* piece, vtkPolyData* output)>;

  /**
   * Call `work` for all pieces, on all processes in the same order. Collective. Without a
   * controller (nullptr) this process has all pieces. An error leaves its output empty and is not a
   * failure of the filter, because the pipeline would then run it again on one process alone. If
   * memory is insufficient for `purpose`, all outputs are empty and the filter reports an
   * ErrorEvent. With several processes, std::bad_alloc ends them, because the others would wait for
   * the process that gives up.
   */
  void Run(vtkAlgorithm* filter, const char* purpose, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector, vtkMultiProcessController* controller, const Work& work);

private:
  void RunPieces(vtkInformationVector** inputVector, vtkInformationVector* outputVector,
    vtkMultiProcessController* controller, const Work& work);

  SurfacePieces Pieces;
};
}

#endif
