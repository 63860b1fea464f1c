// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkReliefWay.h"

#include "vtkReliefMapper.h"

#include "vtkActor.h"
#include "vtkNew.h"

const std::vector<ReliefWay>& GetReliefWays()
{
  static const std::vector<ReliefWay> ways = { ReliefWay::Automatic, ReliefWay::MaximumMipmap,
    ReliefWay::LinearBinary, ReliefWay::LinearSecant, ReliefWay::RelaxedCones,
    ReliefWay::Refinement, ReliefWay::Warp };
  return ways;
}

const char* GetName(ReliefWay way)
{
  switch (way)
  {
    case ReliefWay::Automatic:
      return "automatic";
    case ReliefWay::MaximumMipmap:
      return "rays, maximum mipmap";
    case ReliefWay::LinearBinary:
      return "rays, linear and binary";
    case ReliefWay::LinearSecant:
      return "rays, linear and secant";
    case ReliefWay::RelaxedCones:
      return "rays, relaxed cones";
    case ReliefWay::Refinement:
      return "refinement";
    default:
      return "pre-warp";
  }
}

vtkSmartPointer<vtkActor> MakeReliefActor(ReliefWay way, vtkDataObject* reliefs)
{
  vtkNew<vtkReliefMapper> mapper;
  mapper->SetInputDataObject(reliefs);
  mapper->SetMethodToRayMarch();
  switch (way)
  {
    case ReliefWay::Automatic:
      mapper->SetMethodToAutomatic();
      break;
    case ReliefWay::MaximumMipmap:
      mapper->SetSearchToMaximumMipmap();
      break;
    case ReliefWay::LinearBinary:
      mapper->SetSearchToLinearBinary();
      break;
    case ReliefWay::LinearSecant:
      mapper->SetSearchToLinearSecant();
      break;
    case ReliefWay::RelaxedCones:
      mapper->SetSearchToRelaxedCones();
      break;
    case ReliefWay::Refinement:
      mapper->SetMethodToRefinement();
      break;
    default:
      mapper->SetMethodToWarp();
  }
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}
