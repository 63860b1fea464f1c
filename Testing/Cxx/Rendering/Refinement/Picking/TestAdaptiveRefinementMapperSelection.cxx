// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Hardware selection of what vtkAdaptiveRefinementMapper draws gives the input's cells and points,
// pixel by pixel those that it gives of vtkPolyDataMapper's.
#include "RelevoPicks.h"
#include "RelevoTestMeshes.h"

#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkDisplacement.h"
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

// What a selection of an area gives, as (actor, block, id).
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
      text << name << ": pixel " << i << " is of actor " << hits[i].Actor << ", block "
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
}

int TestAdaptiveRefinementMapperSelection(int, char*[])
{
  RelevoCheck check;
  const int points = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  const int cells = vtkDataObject::FIELD_ASSOCIATION_CELLS;
  vtkNew<vtkPNTriangleSurface> surface;
  vtkNew<RelevoHeights> heights;
  heights->FillRandom(20, 20, 3);
  vtkNew<vtkDisplacement> displacement;
  displacement->SetHeightMap(heights);
  displacement->SetScale(0.2);
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(4);
  recipe->SetSurface(surface);
  recipe->SetDisplacement(displacement);
  vtkNew<vtkAdaptiveRefinement> curved;
  curved->SetMaximumLevel(4);
  curved->SetSurface(surface);

  const struct
  {
    const char* Name;
    Mesh Data;
  } meshes[] = { { "Triangles", Sphere(9, 7) }, { "Quads", Plane(4, 3) }, { "Cube", Cube() },
    { "Polygons", Cone() }, { "Strips", Strips() }, { "Mixed", Mixed() } };

  // Level 0: as vtkPolyDataMapper in every representation.
  for (const auto& mesh : meshes)
  {
    for (int representation : { VTK_SURFACE, VTK_WIREFRAME, VTK_POINTS })
    {
      Pair pair(
        [&](RelevoScene& s)
        {
          vtkProperty* property = s.Add(mesh.Data)->GetProperty();
          property->SetRepresentation(representation);
          property->SetPointSize(9);
          property->SetLineWidth(5);
        });
      const std::string name = std::string(mesh.Name) + " as " +
        pair.Twin.GetActor(0)->GetProperty()->GetRepresentationAsString();
      // A strip's lines run the other way, so other pixels are nearest to them.
      const bool ordered = representation == VTK_SURFACE;
      const size_t tolerance = ordered ? 0 : 50;
      CheckHits(check, name + ", cells", SelectPixels(pair.Refining, cells),
        SelectPixels(pair.Twin, cells), tolerance);
      CheckHits(check, name + ", points", SelectPixels(pair.Refining, points),
        SelectPixels(pair.Twin, points), tolerance);
      if (ordered)
      {
        CHECK(SelectArea(pair.Refining, cells, 0, 0, 299, 299) ==
          SelectArea(pair.Twin, cells, 0, 0, 299, 299));
        CHECK(SelectArea(pair.Refining, cells, 140, 150, 160, 165) ==
          SelectArea(pair.Twin, cells, 140, 150, 160, 165));
        CHECK(SelectArea(pair.Refining, points, 0, 0, 299, 299) ==
          SelectArea(pair.Twin, points, 0, 0, 299, 299));
        CHECK(!SelectArea(pair.Refining, cells, 0, 0, 299, 299).empty());
      }
    }
  }

  // Refined: the filter's cells know which of the input's they come from.
  auto coarse = [](RelevoScene& twin, std::vector<Hit> hits)
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
  };
  for (const auto& mesh : meshes)
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
        // Lines stay where they are, also beside faces that are displaced; the filter's go along.
        s.Add(tagged, std::string(mesh.Name) == "Mixed" ? curved.Get() : recipe.Get());
        vtkActor* second = s.Add(TexturedSphere(6, 5), recipe);
        second->SetPosition(1, 0.2, 0.1);
        second->GetProperty()->SetPointSize(7);
      });
    const std::string name = std::string(mesh.Name) + ", refined";
    // A pixel at a rim may go to the neighbour; see TestAdaptiveRefinementMapperTwin.
    CheckHits(check, name, SelectPixels(pair.Refining, cells),
      coarse(pair.Twin, SelectPixels(pair.Twin, cells)), 10);

    // Points: the input's only, each where the filter's point of the same id is.
    const std::vector<Hit> hits = SelectPixels(pair.Refining, points);
    vtkPolyData* output =
      vtkPolyData::SafeDownCast(pair.Twin.GetActor(0)->GetMapper()->GetInputDataObject(0, 0));
    size_t found = 0;
    for (size_t i = 0; i < hits.size(); ++i)
    {
      if (hits[i].Actor != 0)
      {
        continue;
      }
      if (hits[i].Id < 0 || hits[i].Id >= tagged->GetNumberOfPoints())
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
    CHECK(found > 10);
  }

  // Blocks: the flat index is the composite index; ids are the block's own.
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
        s.Add(outer, recipe);
        return;
      }
      for (const auto& block : blocks)
      {
        s.Add(block.second, recipe);
        flatIndices.push_back(block.first);
      }
    });
  std::vector<Hit> expected = coarse(pair.Twin, SelectPixels(pair.Twin, cells));
  for (Hit& hit : expected)
  {
    if (hit.Actor >= 0)
    {
      hit.Block = flatIndices[static_cast<size_t>(hit.Actor)];
      hit.Actor = 0;
    }
  }
  std::vector<Hit> hits = SelectPixels(pair.Refining, cells);
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
  for (const auto& item : SelectArea(pair.Refining, cells, 0, 0, 299, 299))
  {
    CHECK(item[0] == 0 && blocks.count(static_cast<int>(item[1])) &&
      item[2] < blocks.at(static_cast<int>(item[1]))->GetNumberOfCells());
    indices.insert(item[1]);
  }
  CHECK(indices.size() == 3);
  // Picking leaves no trace in the picture.
  const RelevoPicture before(pair.Refining.Window);
  pair.Refining.Render();
  const RelevoPicture after(pair.Refining.Window);
  pair.Twin.Render();
  CHECK(after.CountForeground() == RelevoPicture(pair.Twin.Window).CountForeground());
  return check.GetResult();
}
