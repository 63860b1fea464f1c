// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   FunctionLoader
 * @brief   the stage that reads the functions of a volume property and uploads them
 *
 * Other changes of the property, such as those of materials, do not read the functions. Private to
 * the module.
 */
#ifndef FunctionLoader_h
#define FunctionLoader_h

#include "Buffers/FunctionBuffers.h"
#include "Buffers/SurfaceBuffer.h"
#include "Changes/Dependencies.h"
#include "Checks/StageReport.h"
#include "Integral/TransferFunctions.h"

#include <string>

class vtkOpenGLRenderWindow;
class vtkVolumeProperty;
class vtkWindow;

namespace relevo
{
struct RayCastMesh;

struct FunctionRequest
{
  vtkOpenGLRenderWindow* Window;
  vtkVolumeProperty* Property;
  int NumberOfComponents;
  const RayCastMesh& Mesh; // for the ranges of the scalars
};

/// The functions, and their buffers on the GPU.
struct VolumeFunctions
{
  TransferFunctions Functions;
  FunctionBuffers Buffers;
  SurfaceBuffer Surfaces;
  vtkIdType Version = 0; // the number of times functions were read
};

class FunctionLoader
{
public:
  /// Read and upload the functions if they or the scalars' ranges have changed. Return whether they
  /// can be used. An error in them is reported once.
  bool Update(const FunctionRequest& request, StageReport& report);

  VolumeFunctions& GetFunctions() { return this->Functions; }
  const VolumeFunctions& GetFunctions() const { return this->Functions; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  std::string Load(const FunctionRequest& request, std::string& warning);

  VolumeFunctions Functions;
  Dependencies Known;
  Dependencies Reported; // reported functions
  std::string Error;     // as reported
  std::string Warning;   // as reported
};
}

#endif
