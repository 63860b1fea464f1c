// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Random calls of the public API on random meshes, good and hostile. A test makes a fixed number of
// runs; RELEVO_FUZZ_RUNS asks for another, RELEVO_FUZZ_FIRST for other seeds, and
// RELEVO_FUZZ_VERBOSE names the calls, of which the last is the one that crashed.
#ifndef RelevoFuzz_h
#define RelevoFuzz_h

#include "vtkBitArray.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#ifdef __unix__
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace RelevoFuzz
{
class Dice
{
public:
  explicit Dice(unsigned int seed)
    : Random(seed)
  {
  }
  // 0 to sides - 1.
  int Throw(int sides) { return static_cast<int>(this->Random() % static_cast<unsigned>(sides)); }
  bool Once(int in) { return this->Throw(in) == 0; }
  double Share() { return this->Random() / 4294967296.0; }
  template <typename T>
  const T& Choose(const std::vector<T>& from)
  {
    return from[static_cast<size_t>(this->Throw(static_cast<int>(from.size())))];
  }
  // Mostly of a sensible size, and now and then not.
  double Number()
  {
    static const std::vector<double> strange = { 0.0, -0.0, 1.0, -1.0, 1e-45, 1e-300, 1e8, -1e9,
      1e20, 1e38, -1e39, 1e300, std::numeric_limits<double>::infinity(),
      std::numeric_limits<double>::quiet_NaN() };
    return this->Once(5) ? this->Choose(strange)
                         : std::pow(10.0, 4.0 * this->Share() - 3.0) * (this->Once(4) ? -1 : 1);
  }
  int Whole() { return this->Once(6) ? this->Choose(Whole_) : this->Throw(6) - 1; }

private:
  std::mt19937 Random;
  const std::vector<int> Whole_ = { -7, 100, 1000000, std::numeric_limits<int>::max(),
    std::numeric_limits<int>::lowest() };
};

// Moves the values to where a page ends that nothing may follow: who reads past the end crashes,
// whether or not a sanitizer has seen its code.
template <typename Array>
void Fence(Array* array, size_t bytes)
{
#ifdef __unix__
  if (bytes == 0)
  {
    return;
  }
  static std::map<void*, std::pair<char*, size_t>> pages;
  const size_t page = static_cast<size_t>(sysconf(_SC_PAGESIZE));
  const size_t used = (bytes + page - 1) / page * page;
  void* first =
    mmap(nullptr, used + page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (first == MAP_FAILED)
  {
    return;
  }
  char* begin = static_cast<char*>(first);
  mprotect(begin + used, page, PROT_NONE);
  void* values = begin + used - bytes;
  std::memcpy(values, array->GetVoidPointer(0), bytes);
  pages[values] = { begin, used + page };
  array->SetVoidArray(values, array->GetNumberOfValues(), 0);
  array->SetArrayFreeFunction(
    [](void* freed)
    {
      munmap(pages[freed].first, pages[freed].second);
      pages.erase(freed);
    });
#endif
}

inline void Fence(vtkDataArray* array)
{
  const auto values = static_cast<size_t>(array->GetNumberOfValues());
  Fence(array,
    array->GetDataType() == VTK_BIT ? (values + 7) / 8
                                    : values * static_cast<size_t>(array->GetDataTypeSize()));
}

inline vtkSmartPointer<vtkAbstractArray> MakeArray(Dice& dice, vtkIdType size)
{
  vtkSmartPointer<vtkAbstractArray> array;
  const int type = dice.Throw(12);
  switch (type)
  {
    case 0:
      array = vtkSmartPointer<vtkBitArray>::New();
      break;
    case 1:
      array = vtkSmartPointer<vtkStringArray>::New();
      break;
    case 2:
      array = vtkSmartPointer<vtkUnsignedCharArray>::New();
      break;
    case 3:
      array = vtkSmartPointer<vtkIntArray>::New();
      break;
    case 4:
      array = vtkSmartPointer<vtkIdTypeArray>::New();
      break;
    case 5:
    case 6:
      array = vtkSmartPointer<vtkDoubleArray>::New();
      break;
    default:
      array = vtkSmartPointer<vtkFloatArray>::New();
  }
  array->SetNumberOfComponents(dice.Once(2) ? 1 : 1 + dice.Throw(5));
  const vtkIdType tuples =
    dice.Once(8) ? std::max<vtkIdType>(0, size - 1 + 3 * dice.Throw(2)) : size;
  array->SetNumberOfTuples(dice.Once(30) ? 0 : tuples);
  if (auto* numbers = vtkDataArray::SafeDownCast(array))
  {
    const bool isReal = numbers->GetDataType() == VTK_FLOAT || numbers->GetDataType() == VTK_DOUBLE;
    const bool isHostile = dice.Once(3);
    for (vtkIdType i = 0; i < numbers->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < numbers->GetNumberOfComponents(); ++c)
      {
        double value = isReal && isHostile ? dice.Number() : 4.0 * dice.Share() - 1.0;
        if (numbers->GetDataType() == VTK_FLOAT && std::abs(value) > 1e38)
        {
          value = 1e38;
        }
        numbers->SetComponent(i, c, isReal ? value : dice.Throw(2));
      }
    }
    Fence(numbers);
  }
  return array;
}

inline void AddArrays(Dice& dice, vtkDataSetAttributes* data, vtkIdType size)
{
  static const std::vector<std::string> names = { "DepthTag", "Field", "Flow", "Normals", "UV",
    "Sharpness", "Tension", "Bias", "Direction", "Alpha", "vtkOriginalCellIds", "vtkGhostType",
    "" };
  for (int i = dice.Throw(5); i > 0; --i)
  {
    auto array = MakeArray(dice, size);
    const std::string name = dice.Choose(names);
    if (name == "vtkGhostType" && !vtkUnsignedCharArray::SafeDownCast(array))
    {
      continue; // VTK itself takes for granted what it is
    }
    array->SetName(name.empty() ? nullptr : name.c_str());
    data->AddArray(array);
    if (auto* numbers = vtkDataArray::SafeDownCast(array))
    {
      const int components = numbers->GetNumberOfComponents();
      switch (dice.Throw(5))
      {
        case 0:
          data->SetScalars(numbers);
          break;
        case 1:
          components == 3 ? data->SetNormals(numbers) : 0;
          break;
        case 2:
          components <= 3 ? data->SetTCoords(numbers) : 0;
          break;
        case 3:
          components == 3 ? data->SetVectors(numbers) : 0;
          break;
        default:
          break;
      }
    }
  }
}

// Of an array that a mesh may have.
inline std::string ChooseName(Dice& dice)
{
  return dice.Choose(std::vector<std::string>{
    "Field", "Flow", "Normals", "Alpha", "Sharpness", "Bias", "no such array", "" });
}

inline vtkSmartPointer<vtkCellArray> MakeCells(
  Dice& dice, int most, int longest, vtkIdType numberOfPoints, bool dangling)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (int i = dice.Throw(most + 1); i > 0; --i)
  {
    const int size = numberOfPoints > 0 || dangling ? dice.Throw(longest + 1) : 0;
    cells->InsertNextCell(size);
    for (int k = 0; k < size; ++k)
    {
      const bool isLost = (dangling && dice.Once(10)) || numberOfPoints == 0;
      cells->InsertCellPoint(isLost ? numberOfPoints + dice.Throw(1000) - 1
                                    : dice.Throw(static_cast<int>(numberOfPoints)));
    }
  }
  return cells;
}

// Duplicate and non-finite points, polygons of 0 to 8 points, strips, lines, vertices, arrays of
// any type and length, at times cells of points that do not exist.
inline vtkSmartPointer<vtkPolyData> MakeMesh(Dice& dice)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  if (dice.Once(25))
  {
    return mesh; // nothing at all
  }
  vtkNew<vtkPoints> points;
  points->SetDataType(dice.Once(3) ? VTK_DOUBLE : VTK_FLOAT);
  const bool isHostile = dice.Once(3);
  const vtkIdType numberOfPoints = dice.Once(20) ? 0 : 3 + dice.Throw(14);
  for (vtkIdType i = 0; i < numberOfPoints; ++i)
  {
    double x[3];
    for (double& coordinate : x)
    {
      coordinate = isHostile && dice.Once(4) ? dice.Number() : 0.25 * dice.Throw(9) - 1.0;
      if (points->GetDataType() == VTK_FLOAT && std::abs(coordinate) > 1e38)
      {
        coordinate = 1e38;
      }
    }
    points->InsertNextPoint(x);
  }
  Fence(points->GetData());
  const bool dangling = dice.Once(12);
  mesh->SetPoints(points);
  mesh->SetPolys(MakeCells(dice, 8, dice.Once(2) ? 8 : 4, numberOfPoints, dangling));
  if (dice.Once(3))
  {
    mesh->SetStrips(MakeCells(dice, 3, 8, numberOfPoints, dangling));
  }
  if (dice.Once(4))
  {
    mesh->SetVerts(MakeCells(dice, 3, 3, numberOfPoints, dangling));
    mesh->SetLines(MakeCells(dice, 3, 4, numberOfPoints, dangling));
  }
  AddArrays(dice, mesh->GetPointData(), numberOfPoints);
  AddArrays(dice, mesh->GetCellData(), mesh->GetNumberOfCells());
  return mesh;
}

// Whether polygons have points that are numbers only.
inline bool IsFinite(vtkPolyData* mesh)
{
  auto cells = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    cells->GetCurrentCell(size, ids);
    for (vtkIdType i = 0; i < size; ++i)
    {
      double x[3];
      mesh->GetPoint(ids[i], x);
      if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
      {
        return false;
      }
    }
  }
  return true;
}

struct Call
{
  std::string Name;
  std::function<void()> Make;
};

inline int GetNumber(const char* variable, int otherwise)
{
  const char* text = std::getenv(variable);
  return text ? std::atoi(text) : otherwise;
}

// A run is a new Machine(dice), and calls that its GetCalls() lists, in random order.
template <typename Machine>
int Run(int runs, int callsPerRun, int& made)
{
  const int first = GetNumber("RELEVO_FUZZ_FIRST", 0);
  const bool isVerbose = GetNumber("RELEVO_FUZZ_VERBOSE", 0) != 0;
  runs = GetNumber("RELEVO_FUZZ_RUNS", runs);
  vtkObject::GlobalWarningDisplayOff();
  int failures = 0;
  for (int seed = first; seed < first + runs; ++seed)
  {
    Dice dice(static_cast<unsigned int>(seed));
    Machine machine(dice);
    const std::vector<Call> calls = machine.GetCalls();
    for (int i = 0; i < callsPerRun; ++i)
    {
      const Call& call = dice.Choose(calls);
      if (isVerbose)
      {
        std::cerr << seed << ": " << call.Name << std::endl;
      }
      call.Make();
      ++made;
      const std::string fault = machine.FindFault();
      if (!fault.empty())
      {
        std::cerr << "seed " << seed << ", call " << i << ", " << call.Name << ": " << fault
                  << "\n";
        ++failures;
        break;
      }
    }
  }
  vtkObject::GlobalWarningDisplayOn();
  return failures;
}
}

#endif
