// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves guide.md on picking: hardware selection returns the input's cells and points, pixel by
// pixel the same as for vtkPolyDataMapper.
#include "RelevoDisplacements.h"
#include "RelevoNamedMeshes.h"
#include "RelevoPicks.h"
#include "RelevoTestMeshes.h"

#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

#include <cmath>
#include <iostream>
#include <map>
#include <set>
#include <sstream>

namespace
{
using namespace RelevoMeshes;
using namespace RelevoPicks;

// The selection of an area as (actor, block, id).
std::set<std::array<vtkIdType, 3>> SelectArea(
  RelevoScene& scene, int association, int xmin, int ymin, int xmax, int ymax)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetArea(xmin, ymin, xmax, ymax);
  selector->SetFieldAssociation(association);
  vtkSmartPointer<vtkSelection> selection;
  selection.TakeReference(selector->Select());
  std::set<std::array<vtkIdType, 3>> result;
  for (unsigned int n = 0; n < selection->GetNumberOfNodes(); ++n)
  {
    vtkSelectionNode* node = selection->GetNode(n);
    vtkInformation* properties = node->GetProperties();
    const vtkIdType actor =
      FindActor(scene, vtkProp::SafeDownCast(properties->Get(vtkSelectionNode::PROP())));
    const vtkIdType block = properties->Has(vtkSelectionNode::COMPOSITE_INDEX())
      ? properties->Get(vtkSelectionNode::COMPOSITE_INDEX())
      : -1;
    vtkIdTypeArray* ids = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
    for (vtkIdType i = 0; ids && i < ids->GetNumberOfTuples(); ++i)
    {
      result.insert({ { actor, block, ids->GetValue(i) } });
    }
  }
  return result;
}

struct Pair
{
  RelevoScene Refining{ RelevoScene::Refining };
  RelevoScene Twin{ RelevoScene::Twin };

  explicit Pair(const RelevoComparison::Builder& build)
  {
    build(this->Twin);
    this->Twin.ResetCameras();
    this->Twin.Render();
    build(this->Refining);
    this->Refining.CopyCameras(this->Twin);
    this->Refining.Render();
  }
};

void CheckHits(RelevoCheck& check, const std::string& name, const std::vector<Hit>& hits,
  const std::vector<Hit>& expected, size_t tolerance = 0)
{
  size_t wrong = 0;
  size_t some = 0;
  for (size_t i = 0; i < expected.size() && i < hits.size(); ++i)
  {
    some += expected[i].Id >= 0;
    if (!(hits[i] == expected[i]) && wrong++ == tolerance)
    {
      std::ostringstream text;
      text << name << ": pixel " << i << " has actor " << hits[i].Actor << ", block "
           << hits[i].Block << ", id " << hits[i].Id << ", not " << expected[i].Actor << ", "
           << expected[i].Block << ", " << expected[i].Id;
      check.Fail(__FILE__, __LINE__, text.str());
    }
  }
  std::cout << name << ": " << wrong << " of " << some << " pixels differ" << std::endl;
  if (hits.size() != expected.size() || some < 100)
  {
    check.Fail(__FILE__, __LINE__, name + ": nothing was hit");
  }
}

constexpr int Points = vtkDataObject::FIELD_ASSOCIATION_POINTS;
constexpr int Cells = vtkDataObject::FIELD_ASSOCIATION_CELLS;

struct Recipes
{
  vtkSmartPointer<vtkAdaptiveRefinement> Curved;
  vtkSmartPointer<vtkAdaptiveRefinement> Displaced;

  Recipes()
  {
    vtkNew<vtkPNTriangleSurface> surface;
    vtkNew<RelevoHeights> heights;
    heights->FillRandom(20, 20, 3);
    this->Curved = MakeRecipe(4, surface);
    this->Displaced = MakeRecipe(4, surface, MakeDisplacement(heights, 0.2));
  }
};

void CheckRepresentation(RelevoCheck& check, const NamedMesh& mesh, int representation)
{
  Pair pair(
    [&](RelevoScene& s)
    {
      vtkProperty* property = s.Add(mesh.Data)->GetProperty();
      property->SetRepresentation(representation);
      property->SetPointSize(9);
      property->SetLineWidth(5);
    });
  const std::string name =
    mesh.Name + " as " + pair.Twin.GetActor(0)->GetProperty()->GetRepresentationAsString();
  // Lines of strips run in the opposite direction, so other pixels are closest to them.
  const bool ordered = representation == VTK_SURFACE;
  const size_t tolerance = ordered ? 0 : 50;
  CheckHits(check, name + ", cells", SelectPixels(pair.Refining, Cells),
    SelectPixels(pair.Twin, Cells), tolerance);
  CheckHits(check, name + ", points", SelectPixels(pair.Refining, Points),
    SelectPixels(pair.Twin, Points), tolerance);
  if (ordered)
  {
    CHECK_EQUAL(SelectArea(pair.Refining, Cells, 0, 0, 299, 299),
      SelectArea(pair.Twin, Cells, 0, 0, 299, 299));
    CHECK_EQUAL(SelectArea(pair.Refining, Cells, 140, 150, 160, 165),
      SelectArea(pair.Twin, Cells, 140, 150, 160, 165));
    CHECK_EQUAL(SelectArea(pair.Refining, Points, 0, 0, 299, 299),
      SelectArea(pair.Twin, Points, 0, 0, 299, 299));
    CHECK(!SelectArea(pair.Refining, Cells, 0, 0, 299, 299).empty());
  }
}

// Equals vtkPolyDataMapper in every representation.
void TestLevel0(RelevoCheck& check)
{
  for (const NamedMesh& mesh : MakeNamedMeshes())
  {
    for (int representation : { VTK_SURFACE, VTK_WIREFRAME, VTK_POINTS })
    {
      CHECK_CASE(representation);
      CheckRepresentation(check, mesh, representation);
    }
  }
}

// Maps the filter's cells to the input's.
std::vector<Hit> ToCoarse(RelevoScene& twin, std::vector<Hit> hits)
{
  for (Hit& hit : hits)
  {
    if (hit.Actor >= 0)
    {
      vtkPolyData* output = vtkPolyData::SafeDownCast(
        twin.GetActor(static_cast<size_t>(hit.Actor))->GetMapper()->GetInputDataObject(0, 0));
      hit.Id = static_cast<vtkIdType>(
        output->GetCellData()->GetArray("vtkOriginalCellIds")->GetComponent(hit.Id, 0));
    }
  }
  return hits;
}

// Only points of the input are found, each at the filter's point of the same id.
void CheckPoints(RelevoCheck& check, const std::string& name, Pair& pair, vtkIdType numberOfPoints)
{
  const std::vector<Hit> hits = SelectPixels(pair.Refining, Points);
  vtkPolyData* output =
    vtkPolyData::SafeDownCast(pair.Twin.GetActor(0)->GetMapper()->GetInputDataObject(0, 0));
  size_t found = 0;
  for (size_t i = 0; i < hits.size(); ++i)
  {
    if (hits[i].Actor != 0)
    {
      continue;
    }
    if (hits[i].Id < 0 || hits[i].Id >= numberOfPoints)
    {
      check.Fail(__FILE__, __LINE__, name + ": point " + std::to_string(hits[i].Id));
      break;
    }
    double world[3];
    output->GetPoint(hits[i].Id, world);
    vtkRenderer* renderer = pair.Refining.Renderer;
    renderer->SetWorldPoint(world[0], world[1], world[2], 1.0);
    renderer->WorldToDisplay();
    const double dx = renderer->GetDisplayPoint()[0] - static_cast<double>(i % 300);
    const double dy = renderer->GetDisplayPoint()[1] - static_cast<double>(i / 300);
    if (dx * dx + dy * dy > 10.0 * 10.0)
    {
      check.Fail(__FILE__, __LINE__,
        name + ": point " + std::to_string(hits[i].Id) + " is hit " +
          std::to_string(std::sqrt(dx * dx + dy * dy)) + " pixels off");
      break;
    }
    ++found;
  }
  std::cout << name << ": points in " << found << " pixels" << std::endl;
  CHECK_GREATER(found, 10);
}

void CheckRefined(RelevoCheck& check, const NamedMesh& mesh, const Recipes& recipes)
{
  Mesh tagged = Make();
  tagged->DeepCopy(mesh.Data);
  AddTags(tagged, 8, 4);
  AddTextureCoordinates(tagged,
    [](const double* p) {
      return std::array<double, 2>{ { 0.2 * p[0] + 0.4, 0.2 * p[1] + 0.4 } };
    });
  Pair pair(
    [&](RelevoScene& s)
    {
      // Lines stay in place, even beside displaced faces. The filter's lines move with them.
      s.Add(tagged, mesh.Name == "Mixed" ? recipes.Curved : recipes.Displaced);
      vtkActor* second = s.Add(TexturedSphere(6, 5), recipes.Displaced);
      second->SetPosition(1, 0.2, 0.1);
      second->GetProperty()->SetPointSize(7);
    });
  const std::string name = mesh.Name + ", refined";
  // A pixel at a border may belong to the neighbour, see TestAdaptiveRefinementMapperTwin.
  CheckHits(check, name, SelectPixels(pair.Refining, Cells),
    ToCoarse(pair.Twin, SelectPixels(pair.Twin, Cells)), 10);
  CheckPoints(check, name, pair, tagged->GetNumberOfPoints());
}

void TestRefined(RelevoCheck& check, const Recipes& recipes)
{
  for (const NamedMesh& mesh : MakeNamedMeshes())
  {
    CheckRefined(check, mesh, recipes);
  }
}

// Picking does not change the picture.
void CheckNoTrace(RelevoCheck& check, Pair& pair)
{
  const RelevoPicture before(pair.Refining.Window);
  pair.Refining.Render();
  const RelevoPicture after(pair.Refining.Window);
  pair.Twin.Render();
  CHECK_EQUAL(after.CountForeground(), RelevoPicture(pair.Twin.Window).CountForeground());
}

// The flat index is the composite index, and ids are those of the block.
void TestBlocks(RelevoCheck& check, const Recipes& recipes)
{
  const double aside[3] = { 1.1, 0.3, 0.0 };
  const double behind[3] = { -1.0, -0.4, 0.0 };
  const std::map<int, Mesh> blocks = { { 2, TexturedSphere(8, 6) },
    { 4, Moved(TexturedSphere(5, 4), 1, aside, VTK_FLOAT) },
    { 6, Moved(TexturedSphere(7, 5), 0.7, behind, VTK_DOUBLE) } };
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, blocks.at(2));
  inner->SetBlock(2, blocks.at(4));
  vtkNew<vtkMultiBlockDataSet> outer;
  outer->SetBlock(0, inner);
  outer->SetBlock(2, blocks.at(6));
  std::vector<int> flatIndices;
  Pair pair(
    [&](RelevoScene& s)
    {
      if (s.Kind == RelevoScene::Refining)
      {
        s.Add(outer, recipes.Displaced);
        return;
      }
      for (const auto& block : blocks)
      {
        s.Add(block.second, recipes.Displaced);
        flatIndices.push_back(block.first);
      }
    });
  std::vector<Hit> expected = ToCoarse(pair.Twin, SelectPixels(pair.Twin, Cells));
  for (Hit& hit : expected)
  {
    if (hit.Actor >= 0)
    {
      hit.Block = flatIndices[static_cast<size_t>(hit.Actor)];
      hit.Actor = 0;
    }
  }
  std::vector<Hit> hits = SelectPixels(pair.Refining, Cells);
  for (Hit& hit : hits)
  {
    hit.Block = hit.Actor < 0 ? -1 : hit.Block;
  }
  for (Hit& hit : expected)
  {
    hit.Block = hit.Actor < 0 ? -1 : hit.Block;
  }
  CheckHits(check, "Blocks, cells", hits, expected, 10);
  std::set<vtkIdType> indices;
  for (const auto& item : SelectArea(pair.Refining, Cells, 0, 0, 299, 299))
  {
    CHECK(item[0] == 0 && blocks.count(static_cast<int>(item[1])) &&
      item[2] < blocks.at(static_cast<int>(item[1]))->GetNumberOfCells());
    indices.insert(item[1]);
  }
  CHECK_EQUAL(indices.size(), 3);
  CheckNoTrace(check, pair);
}
}

int TestAdaptiveRefinementMapperSelection(int, char*[])
{
  RelevoCheck check;
  const Recipes recipes;
  TestLevel0(check);
  TestRefined(check, recipes);
  TestBlocks(check, recipes);
  return check.GetResult();
}
