// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoFuzzRecipe.h"

#include <cmath>

namespace RelevoFuzz
{
RecipeCalls::RecipeCalls(Dice& dice)
  : D(dice)
{
  this->Renew();
}

void RecipeCalls::Renew()
{
  this->Recipe = vtkSmartPointer<vtkAdaptiveRefinement>::New();
  this->Recipe->SetMaximumLevel(this->D.Throw(4));
}

void RecipeCalls::AddTo(std::vector<Call>& calls)
{
  this->AddRecipeCalls(calls);
  this->AddMetricCalls(calls);
  this->AddSurfaceCalls(calls);
  this->AddDisplacementCalls(calls);
}

void RecipeCalls::Print(std::ostream& text)
{
  this->Recipe->Print(text);
  for (vtkObject* object : this->GetMetrics())
  {
    object ? object->Print(text) : void();
  }
  for (vtkObject* object : this->GetSurfaces())
  {
    object ? object->Print(text) : void();
  }
}

std::vector<vtkDepthTagMetric*> RecipeCalls::GetMetrics()
{
  return { nullptr, this->Distance, this->ScreenEdge, this->Curvature, this->Silhouette,
    this->ViewDependent, this->Variation, this->Region, this->Composite };
}

std::vector<vtkRefinementSurface*> RecipeCalls::GetSurfaces()
{
  return { nullptr, this->Linear, this->PN, this->G1, this->Phong, this->Tagged, this->Procedural };
}

void RecipeCalls::AddRecipeCalls(std::vector<Call>& calls)
{
  calls.insert(calls.end(),
    { { "SetMaximumLevel",
        [this] { this->Recipe->SetMaximumLevel(this->D.Once(9) ? 77 : this->D.Throw(4)); } },
      { "SetMetric", [this] { this->Recipe->SetMetric(this->D.Choose(this->GetMetrics())); } },
      { "SetSurface", [this] { this->Recipe->SetSurface(this->D.Choose(this->GetSurfaces())); } },
      { "SetDisplacement",
        [this]
        { this->Recipe->SetDisplacement(this->D.Once(2) ? nullptr : this->Displacement.Get()); } },
      { "SetLevelRule", [this] { this->Recipe->SetLevelRule(this->D.Whole()); } },
      { "SetLevelOffset", [this] { this->Recipe->SetLevelOffset(this->D.Number()); } },
      { "SetSegmentPolicy", [this] { this->Recipe->SetSegmentPolicy(this->D.Whole()); } },
      { "SetGeomorphing", [this] { this->Recipe->SetGeomorphing(this->D.Whole()); } },
      { "SetNoDataMagnitude", [this] { this->Recipe->SetNoDataMagnitude(this->D.Number()); } },
      { "SetDepthTagArrayName",
        [this] { this->Recipe->SetDepthTagArrayName(this->Name().c_str()); } } });
}

void RecipeCalls::AddMetricCalls(std::vector<Call>& calls)
{
  calls.insert(calls.end(),
    { { "Distance",
        [this]
        {
          this->Distance->SetMaximumDistance(this->D.Number());
          this->Distance->SetFallOff(this->D.Whole());
          this->Distance->SetMeasure(this->D.Whole());
        } },
      { "ScreenEdge",
        [this]
        {
          this->ScreenEdge->SetReferenceLength(this->D.Number());
          this->ScreenEdge->SetMeasure(this->D.Whole());
        } },
      { "Curvature",
        [this]
        {
          this->Curvature->SetCurvatureType(this->D.Whole());
          this->Curvature->SetMinimumCurvature(this->D.Number());
          this->Curvature->SetMaximumCurvature(this->D.Number());
          this->Curvature->SetQuantiles(this->D.Number(), this->D.Number());
        } },
      { "Silhouette",
        [this]
        {
          this->Silhouette->SetCriterion(this->D.Whole());
          this->Silhouette->SetContourWidth(this->D.Number());
        } },
      { "ViewDependent",
        [this]
        {
          this->ViewDependent->SetMaximumSpread(this->D.Number());
          this->ViewDependent->SetEdgeOnWeight(this->D.Number());
        } },
      { "FieldVariation",
        [this]
        {
          this->Variation->SetArrayName(this->Name().c_str());
          this->Variation->SetMaximumVariation(this->D.Number());
          this->Variation->SetNoDataMagnitude(this->D.Number());
        } },
      { "Region",
        [this]
        {
          this->Region->SetImplicitFunction(this->D.Once(2) ? nullptr : this->Implicit.Get());
          this->Region->SetCenter(this->D.Number(), this->D.Number(), 0.0);
          this->Region->SetRadius(this->D.Number());
          this->Region->SetFallOff(this->D.Number());
        } },
      { "Composite",
        [this]
        {
          this->Composite->SetMode(this->D.Whole());
          this->Composite->AddMetric(this->D.Choose(this->GetMetrics()), this->D.Number());
        } },
      { "RemoveAllMetrics", [this] { this->Composite->RemoveAllMetrics(); } } });
}

void RecipeCalls::AddSurfaceCalls(std::vector<Call>& calls)
{
  calls.insert(calls.end(),
    { { "PN", [this] { this->PN->SetQuadraticNormals(this->D.Once(2)); } },
      { "G1", [this] { this->G1->SetGeometricNormals(this->D.Once(2)); } },
      { "Phong",
        [this]
        {
          this->Phong->SetAlpha(this->D.Number());
          this->Phong->SetAlphaArrayName(this->Name().c_str());
        } },
      { "ScalarTagged",
        [this]
        {
          this->Tagged->SetSharpnessArrayName(this->Name().c_str());
          this->Tagged->SetDirectionArrayName(this->Name().c_str());
        } },
      { "Procedural",
        [this]
        {
          this->Procedural->SetAmplitude(this->D.Number());
          this->Procedural->SetFrequency(this->D.Number());
          this->Procedural->SetBaseSurface(this->D.Choose(this->GetSurfaces()));
          this->Procedural->SetShaderFunction(this->D.Once(4) ? "nonsense" : nullptr);
        } } });
}

void RecipeCalls::AddDisplacementCalls(std::vector<Call>& calls)
{
  calls.insert(calls.end(),
    { { "displacement",
        [this]
        {
          this->Displacement->SetScale(this->D.Number());
          this->Displacement->SetOffset(this->D.Number());
          this->Displacement->SetHeightMap(this->D.Once(3) ? nullptr : this->Heights.Get());
          this->Displacement->SetNoDataPolicy(this->D.Whole());
        } },
      { "direction",
        [this]
        {
          this->D.Once(2)
            ? this->Displacement->SetDirectionToNormal()
            : this->Displacement->SetDirection(this->D.Number(), this->D.Number(), 1.0);
        } },
      { "heights",
        [this]
        {
          const double height = this->D.Number();
          this->Heights->Fill(1 + this->D.Throw(9), 1 + this->D.Throw(9),
            [height](double u, double v)
            { return std::isfinite(height) ? height * std::sin(9 * u + v) : 0.5; });
          this->D.Once(2) ? this->Heights->Punch([](int x, int y) { return (x + y) % 4 == 0; })
                          : void();
        } } });
}
}
