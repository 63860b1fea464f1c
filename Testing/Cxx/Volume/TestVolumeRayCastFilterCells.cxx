// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkVolumeRayCastFilter promises cells by VTK's shape functions. Distorted cells reproduce a
// linear field exactly; other fields and the cells' borders are compared with many small
// tetrahedra.
#include "RelevoCheck.h"
#include "RelevoDice.h"
#include "RelevoVolumes.h"
#include "RelevoWarnings.h"

#include "vtkVolumeRayCastFilter.h"

#include "vtkCamera.h"
#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace
{
// A cube of side 1 made of n^3 cells, whose inner points are displaced.
class DistortedCube
{
public:
  DistortedCube(int n, double distortion)
    : Side(n + 1)
    , Distortion(distortion / n)
  {
    this->Mesh->SetPoints(this->Points);
    this->Points->SetDataTypeToDouble();
    for (int i = 0; i < this->Side * this->Side * this->Side; ++i)
    {
      this->AddPoint({ { static_cast<double>(i % this->Side) / n,
        static_cast<double>(i / this->Side % this->Side) / n,
        static_cast<double>(i / this->Side / this->Side) / n } });
    }
  }

  vtkSmartPointer<vtkUnstructuredGrid> Fill(const std::vector<int>& types)
  {
    const int n = this->Side - 1;
    for (int cube = 0; cube < n * n * n; ++cube)
    {
      std::array<vtkIdType, 8> corners;
      for (int c = 0; c < 8; ++c)
      {
        corners[c] = cube % n + c % 2 +
          this->Side * (cube / n % n + c / 2 % 2 + this->Side * (cube / n / n + c / 4));
      }
      this->FillCube(types[cube % types.size()], corners);
    }
    vtkNew<vtkDoubleArray> scalars;
    scalars->SetName("field");
    for (vtkIdType i = 0; i < this->Points->GetNumberOfPoints(); ++i)
    {
      RelevoPoint point;
      this->Points->GetPoint(i, point.data());
      scalars->InsertNextValue(GetLinearField(point));
    }
    this->Mesh->GetPointData()->SetScalars(scalars);
    return this->Mesh;
  }

private:
  vtkIdType AddPoint(RelevoPoint point)
  {
    const bool isInner =
      std::all_of(point.begin(), point.end(), [](double x) { return x > 1e-9 && x < 1.0 - 1e-9; });
    for (double& x : point)
    {
      x += isInner ? this->Distortion * this->Dice.Signed() : 0.0;
    }
    return this->Points->InsertNextPoint(point.data());
  }

  vtkIdType AddMiddle(const std::vector<vtkIdType>& points)
  {
    RelevoPoint middle = {};
    for (vtkIdType id : points)
    {
      for (int c = 0; c < 3; ++c)
      {
        middle[c] += this->Points->GetPoint(id)[c] / points.size();
      }
    }
    return this->AddPoint(middle);
  }

  vtkIdType GetEdge(vtkIdType a, vtkIdType b)
  {
    const auto edge = std::minmax(a, b);
    auto found = this->Edges.find(edge);
    if (found == this->Edges.end())
    {
      found = this->Edges.emplace(edge, this->AddMiddle({ a, b })).first;
    }
    return found->second;
  }

  void Insert(int type, const std::array<vtkIdType, 8>& corners, std::vector<vtkIdType> ids)
  {
    for (vtkIdType& id : ids)
    {
      id = corners[id];
    }
    this->Mesh->InsertNextCell(type, static_cast<vtkIdType>(ids.size()), ids.data());
  }

  void FillCube(int type, const std::array<vtkIdType, 8>& c)
  {
    if (type == VTK_HEXAHEDRON)
    {
      this->Insert(type, c, { 0, 1, 3, 2, 4, 5, 7, 6 });
    }
    else if (type == VTK_VOXEL)
    {
      this->Insert(type, c, { 0, 1, 2, 3, 4, 5, 6, 7 });
    }
    else if (type == VTK_WEDGE)
    {
      this->Insert(type, c, { 0, 1, 3, 4, 5, 7 });
      this->Insert(type, c, { 0, 3, 2, 4, 7, 6 });
    }
    else if (type == VTK_PYRAMID)
    {
      const vtkIdType top = this->AddMiddle({ c[0], c[7] });
      const int faces[6][4] = { { 0, 1, 3, 2 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 3, 7, 6 },
        { 0, 2, 6, 4 }, { 1, 3, 7, 5 } };
      for (const auto& face : faces)
      {
        const vtkIdType ids[5] = { c[face[0]], c[face[1]], c[face[2]], c[face[3]], top };
        this->Mesh->InsertNextCell(type, 5, ids);
      }
    }
    else if (type == VTK_QUADRATIC_TETRA)
    {
      const int steps[6][2] = { { 1, 3 }, { 1, 5 }, { 2, 3 }, { 2, 6 }, { 4, 5 }, { 4, 6 } };
      for (const auto& step : steps)
      {
        const vtkIdType p[4] = { c[0], c[step[0]], c[step[1]], c[7] };
        const vtkIdType ids[10] = { p[0], p[1], p[2], p[3], this->GetEdge(p[0], p[1]),
          this->GetEdge(p[1], p[2]), this->GetEdge(p[2], p[0]), this->GetEdge(p[0], p[3]),
          this->GetEdge(p[1], p[3]), this->GetEdge(p[2], p[3]) };
        this->Mesh->InsertNextCell(type, 10, ids);
      }
    }
  }

  vtkSmartPointer<vtkUnstructuredGrid> Mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> Points;
  std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> Edges;
  RelevoDice Dice{ 7 };
  int Side;
  double Distortion;
};

void TestDistorted(RelevoCheck& check)
{
  const std::vector<std::pair<std::vector<int>, double>> fillings = { { { VTK_VOXEL }, 0.0 },
    { { VTK_HEXAHEDRON }, 0.25 }, { { VTK_WEDGE }, 0.2 }, { { VTK_PYRAMID }, 0.1 },
    { { VTK_QUADRATIC_TETRA }, 0.04 }, { { VTK_PYRAMID, VTK_HEXAHEDRON }, 0.15 } };
  const auto property = MakeLinearProperty();
  const auto oblique = MakeCamera({ { 3.0, 2.0, 1.5 } }, { { 0.5, 0.5, 0.5 } });
  const auto inside = MakeCamera({ { 0.4, 0.5, 0.6 } }, { { 3.0, 1.0, 0.0 } }, 80.0);
  const auto along = MakeCamera({ { 0.5, 0.5, 4.0 } }, { { 0.5, 0.5, 0.5 } });
  along->ParallelProjectionOn();
  along->SetParallelScale(11.0 / 24.0); // rays 1/12 apart; some run within faces if these are flat
  for (const auto& filling : fillings)
  {
    const auto mesh = DistortedCube(3, filling.second).Fill(filling.first);
    CHECK_NEAR(FindLargestDifference(
                 Cast(mesh, property, oblique, 24, 18), MakeLinearPicture(oblique, 24, 18)),
      0.0, 1e-5); // near the apex of pyramids, where shape functions are singular
    CHECK_NEAR(FindLargestDifference(
                 Cast(mesh, property, inside, 12, 12), MakeLinearPicture(inside, 12, 12)),
      0.0, 1e-5);
    CHECK_NEAR(
      FindLargestDifference(Cast(mesh, property, along, 11, 11), MakeLinearPicture(along, 11, 11)),
      0.0, 1e-8);
  }
}

// Composite pictures of one scalar prepare cells for the rays of a tile and interpolate
// by cubics. An isosurface, even one out of the range, needs the general way, which divides rays
// until the scalars are linear.
void TestTiles(RelevoCheck& check)
{
  const std::vector<std::pair<std::vector<int>, double>> fillings = { { { VTK_VOXEL }, 0.0 },
    { { VTK_HEXAHEDRON }, 0.35 }, { { VTK_WEDGE }, 0.2 }, { { VTK_PYRAMID, VTK_WEDGE }, 0.15 },
    { { VTK_QUADRATIC_TETRA, VTK_HEXAHEDRON }, 0.04 } };
  const auto property = MakeVolumeProperty(0.2, 1.0, 0.3);
  property->GetScalarOpacity()->AddPoint(0.4, 0.1);
  property->GetScalarOpacity()->AddPoint(0.45, 0.9);
  const auto surfaces = vtkSmartPointer<vtkVolumeProperty>::New();
  surfaces->DeepCopy(property);
  surfaces->GetIsoSurfaceValues()->SetValue(0, 1e6);
  const std::array<vtkSmartPointer<vtkCamera>, 3> cameras = {
    { MakeCamera({ { 3.0, 2.0, 1.5 } }, { { 0.5, 0.5, 0.5 } }),
      MakeCamera({ { 0.4, 0.5, 0.6 } }, { { 3.0, 1.0, 0.0 } }, 80.0),
      MakeCamera({ { 0.5, 0.5, 4.0 } }, { { 0.5, 0.5, 0.5 } }) }
  };
  cameras[1]->SetClippingRange(0.2, 0.7); // planes cut cells
  cameras[2]->ParallelProjectionOn();
  cameras[2]->SetParallelScale(0.3); // the image cuts cells
  for (const auto& filling : fillings)
  {
    CHECK_CASE(filling.first[0]);
    const auto mesh = DistortedCube(3, filling.second).Fill(filling.first);
    vtkDataArray* scalars = mesh->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      const double* p = mesh->GetPoint(i);
      scalars->SetComponent(
        i, 0, 0.5 + 0.4 * std::sin(6.0 * p[0] + 4.0 * p[1] * p[1]) * std::cos(5.0 * p[2]));
    }
    for (const auto& camera : cameras)
    {
      vtkNew<vtkVolumeRayCastFilter> filter;
      filter->SetInputData(mesh);
      filter->SetCamera(camera);
      filter->SetViewportSize(37, 21);
      filter->SetVolumeProperty(property);
      const auto picture = Cast(filter);
      CHECK_GREATER(picture[37 * 10 + 18][3], 0.1);
      filter->SetVolumeProperty(surfaces);
      filter->IsoSurfacesOn();
      const RelevoWarnings warnings(filter); // no surface at this value
      CHECK_NEAR(FindLargestDifference(picture, Cast(filter)), 0.0, 1e-5);
    }
  }
}

// The cell as many small tetrahedra.
vtkSmartPointer<vtkUnstructuredGrid> Divide(vtkUnstructuredGrid* mesh)
{
  vtkCell* cell = mesh->GetCell(0);
  vtkDataArray* scalars = mesh->GetPointData()->GetScalars();
  const auto small = MakeTetrahedra(24, [](const RelevoPoint&) { return 0.0; });
  for (vtkIdType i = 0; i < small->GetNumberOfPoints(); ++i)
  {
    RelevoPoint p;
    small->GetPoint(i, p.data());
    if (cell->GetCellType() == VTK_WEDGE)
    {
      p[1] *= 1.0 - p[0];
    }
    else if (cell->GetCellType() == VTK_QUADRATIC_TETRA)
    {
      p[1] *= 1.0 - p[0];
      p[2] *= 1.0 - p[0] - p[1];
    }
    int part = 0;
    double place[3];
    double weights[10];
    cell->EvaluateLocation(part, p.data(), place, weights);
    small->GetPoints()->SetPoint(i, place);
    double scalar = 0.0;
    for (vtkIdType j = 0; j < cell->GetNumberOfPoints(); ++j)
    {
      scalar += weights[j] * scalars->GetComponent(cell->GetPointId(static_cast<int>(j)), 0);
    }
    small->GetPointData()->GetScalars()->SetComponent(i, 0, scalar);
  }
  return small;
}

// Scalar of a cell at a point, as VTK evaluates it. Returns false outside.
bool FindScalar(vtkUnstructuredGrid* mesh, const RelevoPoint& at, double& scalar)
{
  vtkCell* cell = mesh->GetCell(0);
  double nearest[3];
  double parameters[3];
  double weights[10];
  double squared;
  int part;
  // The region that VTK treats as inside is slightly larger.
  const int found = cell->EvaluatePosition(at.data(), nearest, part, parameters, squared, weights);
  const int type = cell->GetCellType();
  const double sum = type == VTK_WEDGE ? parameters[0] + parameters[1]
    : type == VTK_QUADRATIC_TETRA      ? parameters[0] + parameters[1] + parameters[2]
                                       : 0.0;
  if (found != 1 || sum > 1.0 ||
    std::any_of(parameters, parameters + 3, [](double x) { return x < 0.0 || x > 1.0; }))
  {
    return false;
  }
  scalar = 0.0;
  for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
  {
    scalar += weights[i] * mesh->GetPointData()->GetScalars()->GetComponent(i, 0);
  }
  return true;
}

// Takes many samples, denser towards the ends of the ray's interval.
bool FindExtremes(vtkUnstructuredGrid* mesh, const RelevoRay& ray, double extremes[2])
{
  const int count = 500;
  bool found = false;
  bool wasIn = false;
  double scalar;
  const auto add = [&](double t)
  {
    const bool isIn = FindScalar(mesh, ray.At(t), scalar);
    if (isIn)
    {
      extremes[0] = found ? std::min(extremes[0], scalar) : scalar;
      extremes[1] = found ? std::max(extremes[1], scalar) : scalar;
      found = true;
    }
    return isIn;
  };
  for (int i = 0; i <= count; ++i)
  {
    const double t = 0.8 + 2.6 * i / count;
    const bool isIn = add(t);
    double here = t;
    double before = t - 2.6 / count;
    for (int j = 0; j < 30 && isIn != wasIn; ++j)
    {
      const double middle = 0.5 * (here + before);
      (add(middle) == isIn ? here : before) = middle;
    }
    wasIn = isIn;
  }
  return found;
}

// Opacity is the scalar. A ray that grazes the cell may miss it.
void CheckExtremes(RelevoCheck& check, vtkUnstructuredGrid* mesh, vtkCamera* camera)
{
  const int size = 15;
  vtkNew<vtkVolumeRayCastFilter> filter;
  filter->SetInputData(mesh);
  filter->SetVolumeProperty(MakeVolumeProperty(0.0, 1.0));
  filter->SetCamera(camera);
  filter->SetViewportSize(size, size);
  filter->SetBlendModeToMinimumIntensity();
  const auto lowest = Cast(filter);
  filter->SetBlendModeToMaximumIntensity();
  const auto highest = Cast(filter);
  int compared = 0;
  for (int i = 0; i < size * size; ++i)
  {
    double extremes[2];
    if (FindExtremes(mesh, RelevoRay(camera, i % size, i / size, size, size), extremes) &&
      highest[i][3] > 0.0)
    {
      CHECK_NEAR(lowest[i][3], extremes[0], 4e-5); // accuracy of VTK's search
      CHECK_NEAR(highest[i][3], extremes[1], 4e-5);
      ++compared;
    }
  }
  CHECK_GREATER(compared, 20);
}

// One cell with random points and scalars, so that its border and field are curved.
void TestCurved(RelevoCheck& check)
{
  RelevoDice dice(3);
  const auto property = MakeVolumeProperty(0.0, 1.0, 0.5);
  const auto camera = MakeCamera({ { 1.7, 1.1, 1.9 } }, { { 0.4, 0.4, 0.4 } });
  const auto compare = [&](int type, std::vector<RelevoPoint> corners, double distortion)
  {
    vtkNew<vtkUnstructuredGrid> mesh;
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkDoubleArray> scalars;
    vtkNew<vtkIdList> ids;
    for (RelevoPoint& corner : corners)
    {
      for (double& x : corner)
      {
        x += distortion * dice.Signed();
      }
      ids->InsertNextId(points->InsertNextPoint(corner.data()));
      scalars->InsertNextValue(0.3 + 0.7 * dice.Share());
    }
    mesh->SetPoints(points);
    mesh->GetPointData()->SetScalars(scalars);
    mesh->InsertNextCell(type, ids);
    CheckExtremes(check, mesh, camera);
    vtkNew<vtkVolumeRayCastFilter> divided;
    divided->SetInputData(Divide(mesh));
    divided->SetVolumeProperty(property);
    divided->SetCamera(camera);
    divided->SetViewportSize(21, 21);
    RelevoErrors warnings(divided); // for degenerate tetrahedra at apexes and edges
    CHECK_NEAR(
      FindLargestDifference(Cast(mesh, property, camera, 21, 21), Cast(divided)), 0.0, 2e-3);
  };
  compare(VTK_HEXAHEDRON,
    { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 1, 1, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } },
      { { 1, 0, 1 } }, { { 1, 1, 1 } }, { { 0, 1, 1 } } },
    0.2);
  compare(VTK_WEDGE,
    { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } }, { { 1, 0, 1 } },
      { { 0, 1, 1 } } },
    0.15);
  compare(VTK_PYRAMID,
    { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 1, 1, 0 } }, { { 0, 1, 0 } }, { { 0.5, 0.5, 1 } } },
    0.15);
  compare(VTK_QUADRATIC_TETRA,
    { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } }, { { 0.5, 0, 0 } },
      { { 0.5, 0.5, 0 } }, { { 0, 0.5, 0 } }, { { 0, 0, 0.5 } }, { { 0.5, 0, 0.5 } },
      { { 0, 0.5, 0.5 } } },
    0.08);
}

// VTK may split the cell differently, which has no effect if faces are flat.
void TestSplit(RelevoCheck& check)
{
  const auto cube = DistortedCube(1, 0.0).Fill({ VTK_VOXEL });
  vtkNew<vtkUnstructuredGrid> mesh;
  mesh->SetPoints(cube->GetPoints());
  mesh->GetPointData()->ShallowCopy(cube->GetPointData());
  const vtkIdType faces[] = { 4, 0, 2, 3, 1, 4, 4, 5, 7, 6, 4, 0, 1, 5, 4, 4, 2, 6, 7, 3, 4, 0, 4,
    6, 2, 4, 1, 3, 7, 5 };
  const vtkIdType ids[8] = { 0, 1, 2, 3, 4, 5, 6, 7 };
  mesh->InsertNextCell(VTK_POLYHEDRON, 8, ids, 6, faces);
  const auto camera = MakeCamera({ { 3.0, 2.0, 1.5 } }, { { 0.5, 0.5, 0.5 } });
  const auto picture = Cast(mesh, MakeLinearProperty(), camera, 30, 30);
  CHECK_NEAR(FindLargestDifference(picture, MakeLinearPicture(camera, 30, 30)), 0.0, 1e-12);
}
}

int TestVolumeRayCastFilterCells(int, char*[])
{
  RelevoCheck check;
  TestDistorted(check);
  TestTiles(check);
  TestCurved(check);
  TestSplit(check);
  return check.GetResult();
}
