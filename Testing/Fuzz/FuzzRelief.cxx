// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Reliefs and depth images with arrays and matrices of all kinds: conversion and warping.
#include "RelevoFuzzAssert.h"
#include "RelevoFuzzImages.h"

#include "vtkCamera.h"
#include "vtkDepthImageToRelief.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkReliefWarper.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace
{
using RelevoFuzz::Dice;

double Value(Dice& dice, bool isHostile)
{
  return isHostile ? dice.Number() : 1.0 + dice.Share();
}

vtkSmartPointer<vtkCamera> MakeCamera(Dice& dice)
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  const bool isHostile = dice.Once(6);
  camera->SetPosition(Value(dice, isHostile), Value(dice, isHostile), 6.0);
  camera->SetFocalPoint(2.0, Value(dice, isHostile), -1.0);
  camera->SetParallelProjection(dice.Throw(2));
  camera->SetClippingRange(0.1, 50.0);
  return camera;
}

// An image with the arrays of a relief, of which some may be invalid or missing.
vtkSmartPointer<vtkImageData> MakeRelief(Dice& dice)
{
  if (dice.Once(12))
  {
    return RelevoFuzz::MakeImage(dice);
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(1 + dice.Throw(7), 1 + dice.Throw(7), 1);
  const vtkIdType texels = image->GetNumberOfPoints();
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Color");
  colors->SetNumberOfComponents(3 + dice.Throw(2));
  colors->SetNumberOfTuples(texels);
  colors->Fill(200.0);
  vtkNew<vtkFloatArray> depths;
  depths->SetName("Depth");
  const bool isHostile = dice.Once(3);
  for (vtkIdType i = 0; i < texels; ++i)
  {
    depths->InsertNextValue(
      static_cast<float>(dice.Once(9) ? std::nan("") : Value(dice, isHostile && dice.Once(3))));
  }
  image->GetPointData()->AddArray(colors);
  image->GetPointData()->AddArray(depths);
  vtkNew<vtkIntArray> projection;
  projection->SetName("ReliefProjection");
  projection->InsertNextValue(dice.Once(10) ? dice.Whole() : dice.Throw(2));
  vtkNew<vtkDoubleArray> matrix;
  matrix->SetName("ReliefMatrix");
  const bool isOdd = dice.Once(4);
  for (int i = 0; i < 16; ++i)
  {
    matrix->InsertNextValue(isOdd && dice.Once(3) ? dice.Number() : i % 5 == 0);
  }
  image->GetFieldData()->AddArray(projection);
  image->GetFieldData()->AddArray(matrix);
  RelevoFuzz::AddArrays(dice, image->GetPointData(), texels);
  return image;
}

void Warp(Dice& dice, vtkImageData* relief)
{
  vtkNew<vtkReliefWarper> warper;
  warper->SetInputData(relief);
  warper->SetCamera(MakeCamera(dice));
  warper->SetMaximumStretch(dice.Once(3) ? dice.Number() : 8.0);
  warper->SetPolicy(dice.Throw(4));
  warper->Update();
  vtkImageData* output = warper->GetOutput();
  vtkDataArray* depths = output->GetPointData()->GetArray("Depth");
  for (vtkIdType i = 0; depths && i < depths->GetNumberOfTuples(); ++i)
  {
    FUZZ_ASSERT(!std::isinf(depths->GetComponent(i, 0)));
  }
}

void Convert(Dice& dice)
{
  vtkNew<vtkDepthImageToRelief> filter;
  filter->SetInputData(dice.Once(2) ? MakeRelief(dice) : RelevoFuzz::MakeImage(dice));
  filter->SetInputArrayToProcess(0, 0, 0, 0, dice.Once(3) ? "Field" : "Depth");
  filter->SetDepthScale(dice.Once(2) ? 1.0 : dice.Number());
  filter->SetBottomRowFirst(dice.Once(2));
  if (dice.Once(3))
  {
    filter->SetCamera(MakeCamera(dice));
  }
  else
  {
    filter->SetIntrinsics(Value(dice, dice.Once(9)), Value(dice, dice.Once(9)), 2.0, 1.5);
  }
  vtkNew<vtkMatrix4x4> pose;
  pose->SetElement(dice.Throw(3), dice.Throw(4), dice.Number());
  filter->SetPose(dice.Once(2) ? nullptr : pose.Get());
  filter->Update();
  Warp(dice, filter->GetOutput());
}
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, size_t size)
{
  vtkObject::GlobalWarningDisplayOff();
  Dice dice(bytes, size);
  Warp(dice, MakeRelief(dice));
  Convert(dice);
  return 0;
}
