// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   finds inputs of which a representation draws nothing
 *
 * Private to the module.
 */
#ifndef InputCells_h
#define InputCells_h

class vtkDataObject;
class vtkMultiProcessController;

namespace relevo
{
/// Return the number of faces, or of lines, of all meshes of a tree, which may be nullptr.
double CountFaces(vtkDataObject* tree);
double CountLines(vtkDataObject* tree);

/// Whether the inputs of all processes have cells, but none is drawn. The input may be nullptr.
/// Collective. The result is true on the first process only, which reports it.
bool HasCellsButNone(
  vtkDataObject* input, double numberOfDrawnCells, vtkMultiProcessController* controller);
}

#endif
