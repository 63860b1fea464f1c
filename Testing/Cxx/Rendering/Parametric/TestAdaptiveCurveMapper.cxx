// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkAdaptiveCurveMapper promises the lines, ribbons and tubes of vtkAdaptiveCurveFilter for all
// kinds of curves, with both methods: colours and depths agree.
#include "RelevoCurveScene.h"

#include "vtkDistanceDepthTagMetric.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkProperty.h"

#include <iostream>

namespace
{
using Mapper = vtkAdaptiveCurveMapper;

const char* GetName(int representation)
{
  return representation == Mapper::LINES ? "lines"
    : representation == Mapper::RIBBONS  ? "ribbons"
                                         : "tubes";
}

// The representation determines the number of polygons per segment.
vtkIdType CountSegments(vtkAdaptiveCurveFilter* filter)
{
  vtkPolyData* output = filter->GetOutput();
  vtkIdType segments = 0;
  for (vtkIdType i = 0; i < output->GetNumberOfLines(); ++i)
  {
    segments += output->GetCell(i)->GetNumberOfPoints() - 1;
  }
  return segments;
}

// The mapper lights lines, but the filter's lines have no normals, so lighting is off for the
// comparison.
void Compare(RelevoComparison& comparison, RelevoCurveScene& scene, const std::string& name,
  const RelevoTolerance& tolerance)
{
  for (int representation : { Mapper::LINES, Mapper::RIBBONS, Mapper::TUBES })
  {
    scene.Mapper->SetRepresentation(representation);
    scene.Actor->GetProperty()->SetLighting(representation != Mapper::LINES);
    const RelevoPicture actual = scene.Draw();
    const RelevoPicture expected = scene.DrawTwin();
    const std::string both = name + " " + GetName(representation);
    if (expected.CountForeground() < 150)
    {
      comparison.Fail(both + ": the picture is empty");
    }
    comparison.Compare(both, tolerance, actual, expected);
    if (representation == Mapper::LINES &&
      scene.Mapper->GetNumberOfDrawnSegments() + scene.Mapper->GetNumberOfCulledSegments() !=
        CountSegments(scene.Filter))
    {
      comparison.Fail(both + ": wrong number of segments");
    }
  }
}

void TestKinds(RelevoComparison& comparison)
{
  for (int degree : { 1, 2, 3, 5, 8 })
  {
    for (bool isLagrange : { false, true })
    {
      for (bool isRational : { false, true })
      {
        if (isLagrange && isRational)
        {
          continue; // VTK's have no weights
        }
        RelevoCurveScene scene(RelevoMakeCurves(degree, isLagrange, isRational));
        scene.Mapper->SetRadius(0.04);
        Compare(comparison, scene,
          "degree " + std::to_string(degree) + (isLagrange ? " Lagrange" : "") +
            (isRational ? " rational" : ""),
          { 2, 1e-6, 10 });
      }
    }
  }
}

// Different degrees, and different numbers of segments by distance, in one picture.
void TestLevels(RelevoCheck& check, RelevoComparison& comparison)
{
  const auto grid = RelevoMakeCurves(3);
  const auto other = RelevoMakeCurves(5);
  const auto both = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  both->SetPoints(points);
  both->Allocate(1);
  for (vtkUnstructuredGrid* from : { grid.Get(), other.Get() })
  {
    const vtkIdType first = points->GetNumberOfPoints();
    points->InsertPoints(first, from->GetNumberOfPoints(), 0, from->GetPoints());
    for (vtkIdType cell = 0; cell < from->GetNumberOfCells(); ++cell)
    {
      vtkNew<vtkIdList> ids;
      from->GetCellPoints(cell, ids);
      for (vtkIdType& id : *ids)
      {
        id += first;
      }
      both->InsertNextCell(from->GetCellType(cell), ids);
    }
  }
  RelevoCurveScene scene(both);
  vtkNew<vtkDistanceDepthTagMetric> metric;
  metric->SetMaximumDistance(9.0);
  scene.Recipe->SetMetric(metric);
  scene.Mapper->SetRadius(0.04);
  for (int policy : { 0, 1 })
  {
    CHECK_CASE(policy);
    scene.Recipe->SetSegmentPolicy(policy);
    Compare(comparison, scene, "levels " + std::to_string(policy), { 2, 1e-6, 10 });
    std::cout << scene.Mapper->GetNumberOfDrawCalls() << " draw calls\n";
    CHECK_GREATER(scene.Mapper->GetNumberOfDrawCalls(), 1);
  }
}

void TestRadii(RelevoComparison& comparison)
{
  RelevoCurveScene scene(RelevoMakeCurves(3));
  scene.Mapper->SetRadiusArrayName("Radii");
  scene.Mapper->SetNumberOfSides(5);
  Compare(comparison, scene, "radii", { 2, 1e-6, 10 });
  scene.Actor->SetPosition(1e3, 2e3, 0.0);
  scene.Actor->RotateX(40.0);
  scene.Actor->SetScale(0.3);
  scene.Renderer->ResetCamera();
  Compare(comparison, scene, "radii, moved", { 3, 2e-6, 20 });
  scene.GetCamera()->ParallelProjectionOn();
  scene.Renderer->ResetCamera();
  Compare(comparison, scene, "radii, parallel", { 3, 2e-6, 20 });
}

void TestLooks(RelevoComparison& comparison)
{
  RelevoCurveScene scene(RelevoMakeCurves(3));
  scene.Mapper->SetRadius(0.04);
  vtkProperty* property = scene.Actor->GetProperty();
  property->SetLineWidth(5.0f);
  Compare(comparison, scene, "wide", { 2, 1e-6, 10 });
  property->SetRepresentationToPoints();
  property->SetPointSize(3.0f);
  // Where points or lines coincide, as those of a tube and its cap, the order of drawing decides.
  Compare(comparison, scene, "points", { 3, 1e-6, 120 });
  property->SetLineWidth(1.0f);
  property->SetRepresentationToWireframe();
  Compare(comparison, scene, "wireframe", { 3, 1e-6, 400 });
  property->SetRepresentationToSurface();
  property->SetInterpolationToFlat();
  Compare(comparison, scene, "flat", { 2, 1e-6, 10 });
  property->SetInterpolationToGouraud();
  property->SetOpacity(0.4);
  scene.Renderer->SetUseDepthPeeling(true);
  Compare(comparison, scene, "translucent", { 3, 1e-6, 20 });
}

// OpenGL's tessellator may choose other diagonals.
void TestTessellation(RelevoCheck& check, RelevoComparison& comparison)
{
  RelevoCurveScene scene(RelevoMakeCurves(3));
  scene.Mapper->SetRadius(0.04);
  scene.Mapper->SetMethodToHardwareTessellation();
  scene.Draw();
  if (scene.Mapper->GetMethodInUse() == Mapper::METHOD_HARDWARE_TESSELLATION)
  {
    Compare(comparison, scene, "tessellated", { 24, 2e-3, 60 });
    CHECK_EQUAL(scene.Mapper->GetMethodInUse(), Mapper::METHOD_HARDWARE_TESSELLATION);
    scene.Recipe->SetMaximumLevel(7);
    scene.Mapper->SetRepresentationToLines();
    scene.Draw();
    CHECK_EQUAL(scene.Mapper->GetNumberOfDrawnSegments(), 24 * 64);
  }
  scene.Mapper->SetMethodToInstancing();
  scene.Draw();
  CHECK_EQUAL(scene.Mapper->GetMethodInUse(), Mapper::METHOD_INSTANCING);
}

// Lit lines are shaded like a surface that faces the eye.
void TestLitLines(RelevoCheck& check)
{
  RelevoCurveScene scene(RelevoMakeCurves(3));
  scene.Actor->GetProperty()->LightingOff();
  const RelevoPicture plain = scene.Draw();
  scene.Actor->GetProperty()->LightingOn();
  const RelevoPicture lit = scene.Draw();
  CHECK_EQUAL(lit.CountForeground(), plain.CountForeground());
  size_t darker = 0;
  for (size_t i = 0; i < lit.Colors.size(); ++i)
  {
    CHECK_LESS_EQUAL(lit.Colors[i], plain.Colors[i]);
    darker += lit.Colors[i] < plain.Colors[i] ? 1 : 0;
  }
  CHECK_GREATER(darker, plain.CountForeground() / 2);
}
}

int TestAdaptiveCurveMapper(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  TestKinds(comparison);
  TestLevels(check, comparison);
  TestRadii(comparison);
  TestLooks(comparison);
  TestTessellation(check, comparison);
  TestLitLines(check);
  return check.GetResult();
}
