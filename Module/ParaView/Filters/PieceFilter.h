// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PieceFilter
 * @brief   makes a filter of one surface a filter of the pieces that several processes have
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
  /// Make an output of the type of the input.
  static bool MakeOutput(vtkInformationVector** inputVector, vtkInformationVector* outputVector);

  /**
   * What makes an output of a piece, which has ghosts, the array CellIds, and an order of its own:
   * see SurfacePieces. `own` is the piece as the input has it, but for ghosts of other processes;
   * nullptr where this process has none and only takes part in what is collective.
   */
  using Work = std::function<void(vtkPolyData* own, vtkPolyData* piece, vtkPolyData* output)>;

  /**
   * Call `work` for all pieces, on all processes in the same order. Collective. Without a
   * controller (nullptr) this process has all pieces. An error leaves its output empty and is no
   * failure of the filter: the pipeline would then run it again on one process alone. Without
   * enough memory for `purpose` all outputs are empty, after an ErrorEvent of the filter; but
   * several processes end with std::bad_alloc, because the others would wait for one that gives up.
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
