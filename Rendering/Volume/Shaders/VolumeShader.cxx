// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/VolumeShader.h"

#include "Buffers/PsiTable.h"
#include "relevoLinearSegment.h"
#include "relevoVolumeBorder.h"
#include "relevoVolumeComposite.h"
#include "relevoVolumeEdges.h"
#include "relevoVolumeEntriesFS.h"
#include "relevoVolumeFS.h"
#include "relevoVolumeFunctions.h"
#include "relevoVolumePart.h"
#include "relevoVolumePreIntegrated.h"
#include "relevoVolumeProjectedFS.h"
#include "relevoVolumeProjectionFS.h"
#include "relevoVolumeProjectionVS.h"
#include "relevoVolumeRay.h"
#include "relevoVolumeWalk.h"

#include "vtkShaderProgram.h"

#include <sstream>

namespace relevo
{
namespace
{
void Define(std::ostringstream& text, const char* name, int value)
{
  text << "#define RELEVO_" << name << " " << value << "\n";
}

void Put(std::string& source, const char* anchor, const std::string& text)
{
  vtkShaderProgram::Substitute(source, std::string("//RELEVO::") + anchor, text);
}

void PutRays(std::string& source)
{
  Put(source, "Ray", relevoVolumeRay);
  Put(source, "Edges", relevoVolumeEdges);
  Put(source, "Border", relevoVolumeBorder);
}

std::string DefineOptions(const VolumeShaderOptions& options)
{
  std::ostringstream defines;
  Define(defines, "COMPONENTS", options.NumberOfComponents);
  Define(defines, "CURVES", options.NumberOfCurves);
  Define(defines, "DEPENDENT", options.AreDependent);
  Define(defines, "CELL_SCALARS", options.HasCellScalars);
  Define(defines, "PSI_SIZE", PsiTable::Size);
  Define(defines, "PRE_INTEGRATED", options.PreIntegrated);
  return defines.str();
}

void PutIntegration(std::string& source, const VolumeShaderOptions& options)
{
  Put(source, "Functions", relevoVolumeFunctions);
  Put(source, "LinearSegment", relevoLinearSegment);
  Put(source, "Blend", options.PreIntegrated ? relevoVolumePreIntegrated : relevoVolumeComposite);
  Put(source, "Part", relevoVolumePart);
}
}

std::string MakeEntriesShader()
{
  std::string source = relevoVolumeEntriesFS;
  PutRays(source);
  return source;
}

std::string MakeRayCastShader(const VolumeShaderOptions& options)
{
  std::string source = relevoVolumeFS;
  Put(source, "Defines", DefineOptions(options));
  PutRays(source);
  PutIntegration(source, options);
  Put(source, "Walk", relevoVolumeWalk);
  return source;
}

std::string MakeProjectionVertexShader(const VolumeShaderOptions& options)
{
  std::string source = relevoVolumeProjectionVS;
  Put(source, "Defines", DefineOptions(options));
  return source;
}

std::string MakeProjectionShader(const VolumeShaderOptions& options)
{
  std::string source = relevoVolumeProjectionFS;
  Put(source, "Defines", DefineOptions(options));
  PutRays(source);
  PutIntegration(source, options);
  return source;
}

std::string MakeProjectedShader()
{
  return relevoVolumeProjectedFS;
}
}
