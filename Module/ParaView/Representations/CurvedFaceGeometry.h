// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurvedFaceGeometry
 * @brief   a geometry filter whose output has curved faces
 *
 * Faces of unstructured grids become polygons of their nodes, see FacePolygons.h. Other data sets
 * and the structure of composite data sets are those of PlainGeometry.
 *
 * Private to the module.
 */
#ifndef CurvedFaceGeometry_h
#define CurvedFaceGeometry_h

#include "PlainGeometry.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkPolyData;
class vtkUnstructuredGrid;

namespace relevo
{
class CurvedFaceGeometry : public PlainGeometry
{
public:
  static CurvedFaceGeometry* New();
  vtkTypeMacro(CurvedFaceGeometry, PlainGeometry);

  /// The errors and warnings of the last update; "" if there are none.
  const std::string& GetErrors() const { return this->Errors; }
  const std::string& GetWarnings() const { return this->Warnings; }

protected:
  CurvedFaceGeometry();
  ~CurvedFaceGeometry() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  CurvedFaceGeometry(const CurvedFaceGeometry&) = delete;
  void operator=(const CurvedFaceGeometry&) = delete;

  vtkSmartPointer<vtkPolyData> MakePolygons(vtkUnstructuredGrid* grid);

  void AddMessage(vtkObject* filter, unsigned long event, void* text);

  std::string Prefix; // of messages about the current block
  std::string Errors;
  std::string Warnings;
};
}

#endif
