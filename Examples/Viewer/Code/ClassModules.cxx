// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Code/ClassModules.h"

#include <map>
#include <stdexcept>

namespace
{
using Modules = std::map<std::string, std::string>;

const Modules& GetModulesOfRelevo()
{
  static const Modules modules = {
    { "vtkAdaptiveCurveMapper", "RenderingParametric" },
    { "vtkAdaptiveLICMapper", "RenderingFlow" },
    { "vtkAdaptivePatchMapper", "RenderingParametric" },
    { "vtkAdaptiveRefinement", "FiltersRefinement" },
    { "vtkAdaptiveRefinementMapper", "RenderingRefinement" },
    { "vtkArrayQuantityFilter", "FiltersVolume" },
    { "vtkBezierPatchReader", "FiltersParametric" },
    { "vtkCompositeDepthTagMetric", "FiltersRefinement" },
    { "vtkControlNetDepthTagMetric", "FiltersParametric" },
    { "vtkCreaseNormals", "FiltersRefinement" },
    { "vtkCurvatureDepthTagMetric", "FiltersRefinement" },
    { "vtkCurvedCellCutter", "FiltersVolume" },
    { "vtkDisplacement", "FiltersRefinement" },
    { "vtkDistanceDepthTagMetric", "FiltersRefinement" },
    { "vtkEGLOffscreenRenderWindow", "RenderingOffscreen" },
    { "vtkFieldVariationDepthTagMetric", "FiltersRefinement" },
    { "vtkG1Surface", "FiltersRefinement" },
    { "vtkGPUUnstructuredGridVolumeMapper", "RenderingVolume" },
    { "vtkHeightErrorDepthTagMetric", "FiltersRefinement" },
    { "vtkHeightMap", "FiltersTerrain" },
    { "vtkLICSettings", "FiltersFlow" },
    { "vtkLinearSurface", "FiltersRefinement" },
    { "vtkMicroMeshErrorDepthTagMetric", "FiltersMicroMesh" },
    { "vtkMicroMeshReader", "FiltersMicroMesh" },
    { "vtkMicroMeshSurface", "FiltersMicroMesh" },
    { "vtkPNTriangleSurface", "FiltersRefinement" },
    { "vtkPatchErrorDepthTagMetric", "FiltersParametric" },
    { "vtkPatchSurface", "FiltersParametric" },
    { "vtkPatchSurfaceFilter", "FiltersParametric" },
    { "vtkPhongSurface", "FiltersRefinement" },
    { "vtkProceduralSurface", "FiltersRefinement" },
    { "vtkRegionDepthTagMetric", "FiltersRefinement" },
    { "vtkReliefDatabaseReader", "FiltersRelief" },
    { "vtkReliefMapper", "RenderingRelief" },
    { "vtkScalarTaggedSurface", "FiltersRefinement" },
    { "vtkScreenEdgeDepthTagMetric", "FiltersRefinement" },
    { "vtkSilhouetteDepthTagMetric", "FiltersRefinement" },
    { "vtkSurfaceIntersectionFilter", "FiltersIntersection" },
    { "vtkTerrainContourLabels", "RenderingTerrain" },
    { "vtkTerrainMapper", "RenderingTerrain" },
    { "vtkTerrainPyramid", "FiltersTerrain" },
    { "vtkViewDependentDepthTagMetric", "FiltersRefinement" },
  };
  return modules;
}

const Modules& GetModulesOfVTK()
{
  static const Modules modules = {
    { "vtkActor", "RenderingCore" },
    { "vtkCamera", "RenderingCore" },
    { "vtkCellArray", "CommonDataModel" },
    { "vtkCellData", "CommonDataModel" },
    { "vtkCellDataToPointData", "FiltersCore" },
    { "vtkColorTransferFunction", "RenderingCore" },
    { "vtkContourFilter", "FiltersCore" },
    { "vtkContourValues", "CommonMisc" },
    { "vtkCoordinate", "RenderingCore" },
    { "vtkDataObject", "CommonDataModel" },
    { "vtkGenericDataObjectReader", "IOLegacy" },
    { "vtkGeometryFilter", "FiltersGeometry" },
    { "vtkJPEGReader", "IOImage" },
    { "vtkLight", "RenderingCore" },
    { "vtkLookupTable", "CommonCore" },
    { "vtkMultiBlockDataGroupFilter", "FiltersGeneral" },
    { "vtkOBJReader", "IOGeometry" },
    { "vtkPLYReader", "IOPLY" },
    { "vtkPNGReader", "IOImage" },
    { "vtkPNGWriter", "IOImage" },
    { "vtkPiecewiseFunction", "CommonDataModel" },
    { "vtkPlane", "CommonDataModel" },
    { "vtkPoints", "CommonCore" },
    { "vtkPolyData", "CommonDataModel" },
    { "vtkPolyDataMapper", "RenderingCore" },
    { "vtkPolyDataMapper2D", "RenderingCore" },
    { "vtkActor2D", "RenderingCore" },
    { "vtkProperty", "RenderingCore" },
    { "vtkProperty2D", "RenderingCore" },
    { "vtkRenderWindow", "RenderingCore" },
    { "vtkRenderer", "RenderingCore" },
    { "vtkSTLReader", "IOGeometry" },
    { "vtkScalarsToColors", "CommonCore" },
    { "vtkSphere", "CommonDataModel" },
    { "vtkStreamTracer", "FiltersFlowPaths" },
    { "vtkTextActor", "RenderingCore" },
    { "vtkTextProperty", "RenderingCore" },
    { "vtkTexture", "RenderingCore" },
    { "vtkTubeFilter", "FiltersCore" },
    { "vtkUnsignedCharArray", "CommonCore" },
    { "vtkVolume", "RenderingCore" },
    { "vtkVolumeProperty", "RenderingCore" },
    { "vtkWindowToImageFilter", "RenderingCore" },
    { "vtkXMLImageDataReader", "IOXML" },
    { "vtkXMLPolyDataReader", "IOXML" },
    { "vtkXMLRectilinearGridReader", "IOXML" },
    { "vtkXMLStructuredGridReader", "IOXML" },
    { "vtkXMLUnstructuredGridReader", "IOXML" },
  };
  return modules;
}
}

//------------------------------------------------------------------------------
ClassModule FindModule(const std::string& className)
{
  const auto relevo = GetModulesOfRelevo().find(className);
  if (relevo != GetModulesOfRelevo().end())
  {
    return { relevo->second, true };
  }
  const auto vtk = GetModulesOfVTK().find(className);
  if (vtk == GetModulesOfVTK().end())
  {
    throw std::logic_error(className + " has no entry in ClassModules.cxx");
  }
  return { vtk->second, false };
}
