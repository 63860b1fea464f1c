// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Random calls of a refining mapper and of VTK's classes around it: two mappers, three actors that
// share them, and two windows.
#ifndef RelevoFuzzMapper_h
#define RelevoFuzzMapper_h

#include "RelevoFuzzRecipe.h"
#include "RelevoFuzzStage.h"

#include "vtkAdaptiveRefinementMapper.h"
#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPlane.h"
#include "vtkPointData.h"

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace RelevoFuzz
{
template <typename Mapper>
class MapperMachine : public Stage
{
public:
  explicit MapperMachine(Dice& dice)
    : Stage(dice)
    , Recipe(dice)
  {
    for (auto& mapper : this->Mappers)
    {
      this->Renew(mapper);
    }
    for (vtkActor* actor : this->Actors)
    {
      actor->SetMapper(this->ChooseMapper());
    }
    this->ResetCamera(this->Views[0]);
  }

  std::vector<Call> GetCalls()
  {
    std::vector<Call> calls;
    this->Recipe.AddTo(calls);
    this->AddInputCalls(calls);
    this->AddRefiningCalls(calls);
    this->AddColorCalls(calls);
    this->AddMapperCalls(calls);
    this->AddActorCalls(calls);
    this->AddViewCalls(calls);
    // Draws as often as the other calls together change something visible.
    for (size_t i = calls.size() / 4; i > 0; --i)
    {
      calls.push_back({ "render", [this] { this->Render(this->ChooseView()); } });
    }
    this->AddQuestions(calls);
    return calls;
  }

protected:
  void Renew(vtkSmartPointer<Mapper>& mapper)
  {
    mapper = vtkSmartPointer<Mapper>::New();
    mapper->SetRefinement(this->Recipe.Get());
    mapper->SetInputDataObject(this->MakeInput());
  }
  Mapper* ChooseMapper() { return this->D.Choose(this->Mappers); }
  vtkMapper* ChooseMapperOfActor() override { return this->ChooseMapper(); }
  void AfterRender() override
  {
    for (Mapper* mapper : this->Mappers)
    {
      this->Ask(mapper);
    }
  }

  vtkSmartPointer<vtkDataObject> MakeBlock()
  {
    switch (this->D.Throw(8))
    {
      case 0:
        return nullptr;
      case 1:
        return vtkSmartPointer<vtkPolyData>::New();
      case 2:
        return vtkSmartPointer<vtkImageData>::New();
      default:
        return MakeMesh(this->D);
    }
  }
  vtkSmartPointer<vtkDataObject> MakeInput()
  {
    if (this->D.Throw(4))
    {
      return MakeMesh(this->D);
    }
    if (this->D.Once(5))
    {
      vtkNew<vtkPartitionedDataSetCollection> parts;
      parts->SetNumberOfPartitionedDataSets(2);
      parts->SetPartition(1, static_cast<unsigned int>(this->D.Throw(3)), MakeMesh(this->D));
      return parts;
    }
    vtkNew<vtkMultiBlockDataSet> blocks;
    vtkNew<vtkMultiBlockDataSet> nested;
    for (unsigned int i = 0; i < 2; ++i)
    {
      blocks->SetBlock(i, this->MakeBlock());
      nested->SetBlock(i, this->MakeBlock());
    }
    this->D.Once(2) ? blocks->SetBlock(3, nested) : void();
    return blocks;
  }

  // The mapper's counters must be consistent.
  void Ask(Mapper* mapper)
  {
    if (mapper->GetNumberOfDrawnTriangles() < 0 || mapper->GetNumberOfCulledTriangles() < 0 ||
      mapper->GetNumberOfDrawCalls() < 0 || mapper->GetNumberOfUsedPatterns() < 0 ||
      mapper->GetGraphicsMemorySize() < 0 || !(mapper->GetSelectionTime() >= 0.0))
    {
      this->Say("a number of what is drawn is negative");
    }
    if (mapper->GetNumberOfCulledFaces() < 0 ||
      mapper->GetNumberOfCulledFaces() > mapper->GetNumberOfCoarseFaces())
    {
      this->Say("more faces are culled than there are");
    }
    if (!std::isfinite(mapper->GetLevelOffset()))
    {
      this->Say("the level offset is no number");
    }
    double bounds[6];
    mapper->GetBounds(bounds);
    if (vtkMath::AreBoundsInitialized(bounds))
    {
      for (int i = 0; i < 6; i += 2)
      {
        if (!(bounds[i] <= bounds[i + 1]))
        {
          this->Say("the bounds are no numbers, or the wrong way round");
        }
      }
    }
  }

  void AddInputCalls(std::vector<Call>& calls)
  {
    calls.insert(calls.end(),
      { { "input", [this] { this->ChooseMapper()->SetInputDataObject(this->MakeInput()); } },
        { "no input",
          [this]
          {
            this->D.Once(3) ? this->ChooseMapper()->RemoveAllInputConnections(0)
                            : this->ChooseMapper()->SetInputDataObject(this->MakeInput());
          } },
        { "change of the input",
          [this]
          {
            if (vtkPolyData* mesh = this->ChooseMapper()->GetInput())
            {
              AddArrays(this->D, mesh->GetPointData(), mesh->GetNumberOfPoints());
              AddArrays(this->D, mesh->GetCellData(), mesh->GetNumberOfCells());
              this->D.Once(3) ? mesh->GetPointData()->Initialize() : void();
              mesh->Modified();
            }
          } },
        { "no cells",
          [this]
          {
            vtkPolyData* mesh = this->ChooseMapper()->GetInput();
            mesh&& this->D.Once(3) ? mesh->SetPolys(nullptr) : void();
          } },
        { "recipe",
          [this]
          {
            this->Recipe.Renew();
            this->ChooseMapper()->SetRefinement(this->D.Once(12) ? nullptr : this->Recipe.Get());
          } },
        { "pieces", [this] { this->ChooseMapper()->SetPiece(this->D.Throw(3)); } },
        { "number of pieces",
          [this]
          {
            this->ChooseMapper()->SetNumberOfPieces(1 + this->D.Throw(2));
            this->ChooseMapper()->SetGhostLevel(this->D.Throw(3));
          } } });
  }

  void AddRefiningCalls(std::vector<Call>& calls)
  {
    calls.insert(calls.end(),
      { { "method", [this] { this->ChooseMapper()->SetMethod(this->D.Whole()); } },
        { "device", [this] { this->ChooseMapper()->SetSelectionDevice(this->D.Whole()); } },
        { "target",
          [this]
          {
            this->ChooseMapper()->SetTargetNumberOfTriangles(
              this->D.Once(4) ? this->D.Whole() % 10000 : this->D.Throw(500));
          } },
        { "no target", [this] { this->ChooseMapper()->SetTargetNumberOfTriangles(0); } },
        { "time",
          [this]
          {
            this->ChooseMapper()->SetUseAllocatedRenderTime(this->D.Throw(2));
            this->ChooseView().Window->SetDesiredUpdateRate(std::abs(this->D.Number()));
          } },
        { "culling",
          [this]
          {
            this->ChooseMapper()->SetFrustumCulling(this->D.Throw(2));
            this->ChooseMapper()->SetBackFaceCulling(this->D.Throw(2));
          } },
        { "colours of levels",
          [this]
          {
            Mapper* mapper = this->ChooseMapper();
            mapper->SetLevelLookupTable(MakeTable(this->D));
            const int mode = this->D.Throw(4);
            mode == 0     ? mapper->SetColorModeToScalars()
              : mode == 1 ? mapper->SetColorModeToLevel()
              : mode == 2 ? mapper->SetColorModeToPattern()
                          : mapper->SetColorModeToMetric();
          } },
        { "copy", [this] { this->ChooseMapper()->ShallowCopy(this->ChooseMapper()); } } });
  }

  void AddColorCalls(std::vector<Call>& calls)
  {
    calls.insert(calls.end(),
      { { "table", [this] { this->ChooseMapper()->SetLookupTable(MakeTable(this->D)); } },
        { "array",
          [this]
          {
            Mapper* mapper = this->ChooseMapper();
            mapper->SetScalarMode(this->D.Throw(6));
            this->D.Once(2)
              ? mapper->ColorByArrayComponent(ChooseName(this->D).c_str(), this->D.Throw(5) - 1)
              : mapper->ColorByArrayComponent(this->D.Throw(5) - 1, this->D.Throw(5) - 1);
            mapper->SetFieldDataTupleId(this->D.Throw(5) - 1);
          } },
        { "colours",
          [this]
          {
            vtkMapper* mapper = this->ChooseMapper();
            mapper->SetInterpolateScalarsBeforeMapping(this->D.Throw(2));
            mapper->SetScalarVisibility(this->D.Throw(4) != 0);
            mapper->SetColorMode(this->D.Throw(3));
          } },
        { "range",
          [this]
          {
            vtkMapper* mapper = this->ChooseMapper();
            mapper->SetScalarRange(this->D.Number(), this->D.Number());
            mapper->SetUseLookupTableScalarRange(this->D.Throw(2));
          } } });
  }

  void AddMapperCalls(std::vector<Call>& calls)
  {
    calls.insert(calls.end(),
      { { "clipping",
          [this]
          {
            Mapper* mapper = this->ChooseMapper();
            vtkNew<vtkPlane> plane;
            plane->SetNormal(this->D.Number(), this->D.Number(), 1.0);
            plane->SetOrigin(this->D.Number(), 0.0, 0.0);
            this->D.Once(2) ? mapper->RemoveAllClippingPlanes() : mapper->AddClippingPlane(plane);
          } },
        { "attributes",
          [this]
          {
            Mapper* mapper = this->ChooseMapper();
            const std::string name = ChooseName(this->D);
            this->D.Once(3) ? mapper->RemoveAllVertexAttributeMappings()
                            : mapper->MapDataArrayToVertexAttribute(
                                "extra", name.c_str(), this->D.Throw(2), this->D.Throw(4) - 1);
          } },
        { "ids",
          [this]
          {
            Mapper* mapper = this->ChooseMapper();
            mapper->SetPointIdArrayName(ChooseName(this->D).c_str());
            mapper->SetCellIdArrayName(ChooseName(this->D).c_str());
            mapper->SetCompositeIdArrayName(ChooseName(this->D).c_str());
            mapper->SetProcessIdArrayName(ChooseName(this->D).c_str());
          } },
        { "no ids",
          [this]
          {
            Mapper* mapper = this->ChooseMapper();
            mapper->SetPointIdArrayName(nullptr);
            mapper->SetCellIdArrayName(nullptr);
            mapper->SetCompositeIdArrayName(nullptr);
            mapper->SetProcessIdArrayName(nullptr);
          } },
        { "shift and scale",
          [this]
          {
            Mapper* mapper = this->ChooseMapper();
            mapper->SetVBOShiftScaleMethod(this->D.Throw(5));
            mapper->SetStatic(this->D.Once(4));
            mapper->SetSeamlessU(this->D.Throw(2));
          } },
        { "another mapper",
          [this] { this->Renew(this->Mappers[static_cast<size_t>(this->D.Throw(2))]); } } });
  }

  void AddQuestions(std::vector<Call>& calls)
  {
    calls.insert(calls.end(),
      { { "print", [this] { this->Print(); } },
        { "ask", [this] { this->Ask(this->ChooseMapper()); } },
        { "ask the class",
          [this]
          {
            Mapper* mapper = this->ChooseMapper();
            mapper->HasOpaqueGeometry();
            mapper->HasTranslucentPolygonalGeometry();
            mapper->GetMethodInUse();
            mapper->GetSelectionDeviceInUse();
            mapper->GetInput();
          } },
        { "update", [this] { this->ChooseMapper()->Update(); } },
        { "pick", [this] { this->Pick(); } }, { "pick", [this] { this->Pick(); } },
        { "select", [this] { this->Select(); } } });
  }

  void Print()
  {
    std::ostringstream text;
    this->ChooseMapper()->Print(text);
    this->ChooseActor()->Print(text);
    this->Recipe.Print(text);
  }

  RecipeCalls Recipe;
  std::vector<vtkSmartPointer<Mapper>> Mappers = std::vector<vtkSmartPointer<Mapper>>(2);
};
}

#endif
