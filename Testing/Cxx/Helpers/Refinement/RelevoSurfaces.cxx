// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoSurfaces.h"

#include "vtkG1Surface.h"
#include "vtkNew.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPhongSurface.h"
#include "vtkProceduralSurface.h"
#include "vtkScalarTaggedSurface.h"

std::vector<std::pair<std::string, vtkSmartPointer<vtkRefinementSurface>>> RelevoMakeSurfaces(
  double size)
{
  vtkNew<vtkPNTriangleSurface> quadratic;
  vtkNew<vtkPNTriangleSurface> linearNormals;
  linearNormals->QuadraticNormalsOff();
  vtkNew<vtkPhongSurface> phong;
  vtkNew<vtkPhongSurface> partlyPhong;
  partlyPhong->SetAlpha(0.6);
  vtkNew<vtkProceduralSurface> fur;
  fur->SetAmplitude(0.1 * size);
  fur->SetFrequency(2.5);
  vtkNew<vtkProceduralSurface> furOnPN;
  furOnPN->SetAmplitude(-0.05 * size);
  furOnPN->SetBaseSurface(quadratic);
  vtkNew<vtkG1Surface> g1;
  vtkNew<vtkG1Surface> g1Geometric;
  g1Geometric->GeometricNormalsOn();
  vtkNew<vtkScalarTaggedSurface> creases;
  vtkNew<vtkScalarTaggedSurface> cusps;
  cusps->SetDirectionArrayName(nullptr);
  vtkNew<vtkProceduralSurface> furOnCreases;
  furOnCreases->SetAmplitude(0.05 * size);
  furOnCreases->SetBaseSurface(creases);
  return { { "linear", nullptr }, { "PN, quadratic normals", quadratic },
    { "PN, linear normals", linearNormals }, { "Phong", phong }, { "Phong 0.6", partlyPhong },
    { "fur", fur }, { "fur on PN", furOnPN }, { "G1", g1 }, { "G1, its own normals", g1Geometric },
    { "scalar tags", creases }, { "scalar tags without directions", cusps },
    { "fur on scalar tags", furOnCreases } };
}
