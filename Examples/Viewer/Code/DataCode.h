// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   adds the data of a scene to its program
 *
 * The program reads the user's file if VTK's readers and public filters make the same data of it,
 * to the bit. Otherwise, the data are saved beside the program.
 */
#ifndef DataCode_h
#define DataCode_h

#include <optional>
#include <string>

class SceneCode;
class vtkDataObject;
class vtkDataSet;
class vtkPolyData;

/// The changes that a scene has made to the data of a file.
struct DataPreparation
{
  std::string Input;
  std::string Quantity;    // an array, or a quantity of one; empty for none
  bool HasPatches = false; // of curved cells
  bool HasCreases = false;
  std::optional<double> FeatureAngle = {}; // of creases, in degrees
};

/// Data that are saved beside the program, in a file with this name. Throws ViewerError.
void AddSavedDataCode(SceneCode& code, vtkDataObject* data, const std::string& name);

/// The picture in a file, which a texture uses.
void AddImageCode(SceneCode& code, const std::string& fileName, vtkDataObject* image);

/// The data that an object of the scene uses.
void AddDataCode(SceneCode& code, const DataPreparation& preparation, vtkDataObject* data);

/// A surface, and the cells that it bounds if the scene uses them, otherwise nullptr.
void AddSurfaceDataCode(
  SceneCode& code, const DataPreparation& preparation, vtkPolyData* surface, vtkDataSet* cells);

#endif
