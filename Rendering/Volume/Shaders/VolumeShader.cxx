// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/VolumeShader.h"

#include "Targets/RenderTarget.h"
#include "View/MeshPlanes.h"
#include "relevoLinearSegment.h"
#include "relevoVolumeActiveFS.h"
#include "relevoVolumeAverage.h"
#include "relevoVolumeBorder.h"
#include "relevoVolumeCells.h"
#include "relevoVolumeComposite.h"
#include "relevoVolumeCountFS.h"
#include "relevoVolumeCurvedWalk.h"
#include "relevoVolumeEdges.h"
#include "relevoVolumeEntriesFS.h"
#include "relevoVolumeEntriesVS.h"
#include "relevoVolumeExtreme.h"
#include "relevoVolumeFS.h"
#include "relevoVolumeFaceOutline.h"
#include "relevoVolumeFaces.h"
#include "relevoVolumeFinishFS.h"
#include "relevoVolumeFirstFS.h"
#include "relevoVolumeFunctions.h"
#include "relevoVolumeGradients.h"
#include "relevoVolumeHanging.h"
#include "relevoVolumeIsoSurface.h"
#include "relevoVolumeLastFS.h"
#include "relevoVolumeLimitsFS.h"
#include "relevoVolumeNearestFS.h"
#include "relevoVolumeNearestVS.h"
#include "relevoVolumeOutline.h"
#include "relevoVolumeOutlinesFS.h"
#include "relevoVolumePart.h"
#include "relevoVolumePreIntegrated.h"
#include "relevoVolumeProjectedFS.h"
#include "relevoVolumeProjectionFS.h"
#include "relevoVolumeProjectionVS.h"
#include "relevoVolumeRangesFS.h"
#include "relevoVolumeRay.h"
#include "relevoVolumeSegments.h"
#include "relevoVolumeShading.h"
#include "relevoVolumeStarts.h"
#include "relevoVolumeSteps.h"
#include "relevoVolumeStore.h"
#include "relevoVolumeSurfaces.h"
#include "relevoVolumeVisible.h"
#include "relevoVolumeVisibleVS.h"
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

// GLSL below 4.2 does not support line continuations.
std::string JoinLines(std::string text)
{
  const std::string goesOn = "\\\n";
  for (size_t at = text.find(goesOn); at != std::string::npos; at = text.find(goesOn, at))
  {
    text.erase(at, goesOn.size());
  }
  return text;
}

void Put(std::string& source, const char* anchor, const std::string& text)
{
  vtkShaderProgram::Substitute(source, std::string("//RELEVO::") + anchor, JoinLines(text));
}

std::string DefineCells(const VolumeShaderOptions& options)
{
  std::ostringstream defines;
  Define(defines, "CURVED", options.HasCurvedCells);
  Define(defines, "QUADRATIC", options.HasQuadraticCells);
  Define(defines, "PYRAMIDS", options.HasPyramids);
  Define(defines, "FOLDED", options.HasFoldedFaces);
  Define(defines, "DISCONTINUOUS", options.IsDiscontinuous);
  Define(defines, "HANGING", options.HasHangingFaces);
  Define(defines, "ACTIVE", options.HasActiveCells);
  Define(defines, "VISIBLE", options.HasVisibleCells);
  const bool hasSegments = options.Segments != SegmentOutput::None;
  Define(defines, "SEGMENTS", static_cast<int>(options.Segments));
  // A surface on a shared face must be in one of the pieces.
  Define(defines, "SAME_SUMS", hasSegments && options.HasSurfaces);
  Define(defines, "WIDTH", GetSegmentFormat(options).GetWidth());
  Define(defines, "VALUES", hasSegments ? GetSegmentFormat(options).GetNumberOfValues() : 0);
  Define(defines, "ORDERED", GetSegmentFormat(options).IsOrdered());
  // Only GLSL 4.0 has the qualifier.
  defines << "#define RELEVO_PRECISE "
          << (options.Segments == SegmentOutput::Buffer ? "precise" : "") << "\n";
  defines << "#define RELEVO_TETRAHEDRA " << (options.HasTetrahedra ? "true" : "false") << "\n";
  return defines.str();
}

void PutRays(std::string& source, const VolumeShaderOptions& options)
{
  Put(source, "Cells", options.HasCurvedCells ? relevoVolumeCells : "");
  const std::string hanging = options.HasHangingFaces ? relevoVolumeHanging : "";
  Put(source, "Faces", options.HasCurvedCells ? relevoVolumeFaces + hanging : "");
  Put(source, "Ray", relevoVolumeRay);
  Put(source, "Edges", relevoVolumeEdges);
  Put(source, "Border", relevoVolumeBorder);
  Put(source, "Starts", relevoVolumeStarts);
}

void DefineFeatures(std::ostringstream& defines, const VolumeShaderOptions& options)
{
  const BlendMode blending = options.Blending;
  const bool isExtreme = blending == BlendMode::Maximum || blending == BlendMode::Minimum;
  const bool isMapped = isExtreme || blending == BlendMode::Average;
  Define(defines, "FIRST_COMPONENT", options.FirstComponent);
  Define(defines, "TABLES", options.HasTables);
  Define(defines, "GRADIENT_OPACITY", options.HasGradientOpacity);
  Define(defines, "STEEPNESS",
    (options.HasTables || options.HasGradientOpacity) && !options.HasCellScalars);
  Define(defines, "FACTORS", isMapped || options.HasGradientOpacity);
  Define(defines, "MAPPED", isMapped);
  Define(defines, "EXTREME", isExtreme);
  Define(defines, "AVERAGE", blending == BlendMode::Average);
  Define(defines, "ADDITIVE", blending == BlendMode::Additive);
  Define(defines, "SIGN", blending == BlendMode::Minimum ? -1 : 1);
  Define(defines, "NONE", static_cast<int>(RenderTarget::Empty));
  Define(defines, "SURFACES", options.HasSurfaces);
  Define(defines, "CLIPPED", options.IsClipped);
  Define(defines, "MOST_PLANES", MeshPlanes::MaximumPlanes);
  Define(defines, "LIT", options.NumberOfMaterials > 0);
  Define(defines, "MATERIALS", options.NumberOfMaterials);
  Define(defines, "SHADED_COMPONENT", options.FirstMaterial);
  Define(defines, "LIGHTS", options.NumberOfLights);
}

// Return whether functions are integrated piece by piece.
bool IsIntegrated(const VolumeShaderOptions& options)
{
  return (options.Blending == BlendMode::Composite || options.Blending == BlendMode::Additive) &&
    options.PreIntegrated == 0;
}

// Return whether projected cells find the pieces of a single function that they need, and whether
// any of them is visible. A segment of a ray is then integrated piece by piece.
bool FindsPieces(const VolumeShaderOptions& options)
{
  return IsIntegrated(options) && options.NumberOfCurves == 1 && options.NumberOfComponents == 1 &&
    !options.HasTables && !options.HasSurfaces;
}

std::string DefineOptions(const VolumeShaderOptions& options)
{
  std::ostringstream defines;
  Define(defines, "COMPONENTS", options.NumberOfComponents);
  Define(defines, "CURVES", options.NumberOfCurves);
  Define(defines, "DEPENDENT", options.AreDependent);
  Define(defines, "MIXED", options.NumberOfCurves > 1 && !options.AreDependent);
  Define(defines, "CELL_SCALARS", options.HasCellScalars);
  Define(defines, "CORNER_SCALARS", options.HasCornerScalars);
  Define(defines, "PRE_INTEGRATED", options.PreIntegrated);
  Define(defines, "INTEGRATED", IsIntegrated(options));
  Define(defines, "ISOSURFACE", options.Blending == BlendMode::IsoSurface);
  DefineFeatures(defines, options);
  Define(defines, "CUT_BY_NEAR", options.IsCutByNear);
  Define(defines, "SEEN_PIECE", FindsPieces(options));
  return defines.str();
}

std::string GetBlending(const VolumeShaderOptions& options)
{
  const std::string surfaces = options.HasSurfaces ? relevoVolumeSurfaces : "";
  switch (options.Blending)
  {
    case BlendMode::Maximum:
    case BlendMode::Minimum:
      return relevoVolumeExtreme;
    case BlendMode::Average:
      return relevoVolumeAverage;
    case BlendMode::IsoSurface:
      return surfaces + relevoVolumeIsoSurface;
    default:
      return options.PreIntegrated ? relevoVolumePreIntegrated : surfaces + relevoVolumeComposite;
  }
}

void PutIntegration(std::string& source, const VolumeShaderOptions& options)
{
  Put(source, "Functions", relevoVolumeFunctions);
  Put(source, "LinearSegment", relevoLinearSegment);
  Put(source, "Gradients", relevoVolumeGradients);
  Put(source, "Shading", relevoVolumeShading);
  Put(source, "Blend", GetBlending(options));
  Put(source, "Part", relevoVolumePart);
}

void PutWalk(std::string& source, const VolumeShaderOptions& options)
{
  Put(source, "Defines", DefineOptions(options) + DefineCells(options));
  PutRays(source, options);
  PutIntegration(source, options);
  Put(source, "Walk", relevoVolumeWalk);
  Put(source, "CurvedWalk", options.HasCurvedCells ? relevoVolumeCurvedWalk : "");
}
}

SegmentFormat GetSegmentFormat(const VolumeShaderOptions& options)
{
  const bool areIndependent = !options.AreDependent && options.NumberOfCurves > 0;
  return { options.Blending, areIndependent, options.NumberOfComponents, options.HasTables };
}

namespace
{
void PutOutlines(std::string& source, const VolumeShaderOptions& options)
{
  Put(source, "Defines", DefineCells(options));
  Put(source, "Outline", relevoVolumeOutline);
  Put(source, "Cells", options.HasCurvedCells ? relevoVolumeCells : "");
  Put(source, "Starts", relevoVolumeStarts);
  Put(source, "FaceOutline", relevoVolumeFaceOutline);
}
}

std::string MakeEntriesVertexShader(const VolumeShaderOptions& options)
{
  std::string source = relevoVolumeEntriesVS;
  PutOutlines(source, options);
  return source;
}

std::string MakeEntriesShader(const VolumeShaderOptions& options)
{
  std::string source = relevoVolumeEntriesFS;
  Put(source, "Defines", DefineCells(options));
  PutRays(source, options);
  return source;
}

std::string MakeCountShader(const VolumeShaderOptions& options)
{
  std::string source = relevoVolumeCountFS;
  Put(source, "Defines", DefineCells(options));
  PutRays(source, options);
  return source;
}

std::string MakeRangesShader(const VolumeShaderOptions& options)
{
  std::string source = relevoVolumeRangesFS;
  Put(source, "Defines", DefineOptions(options) + DefineCells(options));
  Put(source, "Cells", options.HasCurvedCells ? relevoVolumeCells : "");
  return source;
}

std::string MakeActiveShader(const VolumeShaderOptions& options)
{
  std::string source = relevoVolumeActiveFS;
  Put(source, "Defines", DefineOptions(options) + DefineCells(options));
  Put(source, "Cells", options.HasCurvedCells ? relevoVolumeCells : "");
  return source;
}

std::string MakeOutlinesShader(const VolumeShaderOptions& options)
{
  std::string source = relevoVolumeOutlinesFS;
  PutOutlines(source, options);
  return source;
}

std::string MakeVisibleVertexShader(const VolumeShaderOptions& options)
{
  std::string source = relevoVolumeVisibleVS;
  PutOutlines(source, options);
  return source;
}

std::string MakeFirstShader(const VolumeShaderOptions& options)
{
  std::string source = relevoVolumeFirstFS;
  Put(source, "Defines", DefineCells(options));
  PutRays(source, options);
  return source;
}

std::string MakeLastShader()
{
  return relevoVolumeLastFS;
}

std::string MakeNearestVertexShader(const VolumeShaderOptions& options)
{
  std::string source = relevoVolumeNearestVS;
  PutOutlines(source, options);
  return source;
}

std::string MakeNearestShader(const VolumeShaderOptions& options)
{
  std::string source = relevoVolumeNearestFS;
  PutWalk(source, options);
  return source;
}

std::string MakeRayCastShader(const VolumeShaderOptions& options)
{
  std::string source = relevoVolumeFS;
  PutWalk(source, options);
  Put(source, "Visible", options.HasVisibleCells ? relevoVolumeVisible : "");
  Put(source, "Segments", options.Segments != SegmentOutput::None ? relevoVolumeSegments : "");
  if (options.Segments == SegmentOutput::Buffer)
  {
    vtkShaderProgram::Substitute(source, "//VTK::System::Dec", "#version 430\n");
  }
  return source;
}

std::string MakeProjectionVertexShader(const VolumeShaderOptions& options)
{
  VolumeShaderOptions ofCells = options;
  ofCells.NumberOfMaterials = 0; // materials are those of rays
  std::string source = relevoVolumeProjectionVS;
  Put(source, "Defines", DefineOptions(ofCells));
  Put(source, "Outline", relevoVolumeOutline);
  Put(source, "Functions", relevoVolumeFunctions);
  Put(source, "LinearSegment", relevoLinearSegment);
  Put(source, "Gradients", relevoVolumeGradients);
  return source;
}

std::string MakeProjectionShader(const VolumeShaderOptions& options)
{
  std::string source = relevoVolumeProjectionFS;
  Put(source, "Defines", DefineOptions(options));
  PutRays(source, options);
  if (FindsPieces(options))
  {
    Put(source, "Blend", relevoVolumeSteps);
  }
  PutIntegration(source, options);
  Put(source, "Store", IsStored(options) ? relevoVolumeStore : "");
  return source;
}

bool IsStored(const VolumeShaderOptions& options)
{
  return options.Blending != BlendMode::Composite && options.Blending != BlendMode::IsoSurface;
}

std::string MakeFinishShader(const VolumeShaderOptions& options)
{
  std::string source = relevoVolumeFinishFS;
  Put(source, "Defines", DefineOptions(options));
  PutRays(source, options);
  PutIntegration(source, options);
  return source;
}

std::string MakeLimitsShader(const VolumeShaderOptions& options)
{
  VolumeShaderOptions asked;
  asked.IsClipped = options.IsClipped;
  std::string source = relevoVolumeLimitsFS;
  Put(source, "Defines", DefineOptions(asked));
  Put(source, "Ray", relevoVolumeRay);
  Put(source, "Part", relevoVolumePart);
  return source;
}

std::string MakeProjectedShader()
{
  return relevoVolumeProjectedFS;
}
}
