// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkReliefWarper.h"

#include "Arrays/ImageExtents.h"
#include "Changes/LatestTime.h"
#include "Checks/InputType.h"
#include "Checks/MemoryGuard.h"
#include "Checks/SettingChecks.h"
#include "View/CameraEye.h"
#include "Warp/WarpCoefficients.h"
#include "Warp/WarpPasses.h"
#include "Warp/WarpSource.h"
#include "Warp/WarpWorker.h"
#include "Warp/WarpedImage.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiThreader.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkTimeStamp.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkReliefWarper);
vtkCxxSetSmartPointerMacro(vtkReliefWarper, Camera, vtkCamera);

namespace
{
// If only position and focal point matter, the eye is computed from these alone, so that other
// changes of the camera do not cause another warp.
relevo::dvec4 FindEye(vtkCamera* camera)
{
  const double* shear = camera->GetViewShear();
  if (camera->GetUseExplicitProjectionTransformMatrix() || camera->GetUseOffAxisProjection() ||
    camera->GetUserTransform() || camera->GetUserViewTransform() || shear[0] != 0.0 ||
    shear[1] != 0.0)
  {
    vtkNew<vtkMatrix4x4> identity;
    return relevo::GetEye(camera, identity);
  }
  relevo::dvec4 eye(0.0, 0.0, 0.0, camera->GetParallelProjection() ? 0.0 : 1.0);
  if (camera->GetParallelProjection())
  {
    camera->GetDirectionOfProjection(&eye.x);
    return -eye;
  }
  camera->GetPosition(&eye.x);
  return eye;
}
}

class vtkReliefWarper::Internals
{
public:
  // The requested input and settings.
  std::shared_ptr<const relevo::WarpSource> Source;
  vtkSmartPointer<vtkImageData> Input; // input of the source; the reference keeps its address valid
  vtkMTimeType InputTime = 0;
  double Stretch = 0.0;
  vtkMTimeType WarpedSettings = 0; // modification time of the filter at the last warp
  bool IsWarned = false;

  relevo::WarpedImage Shown;
  relevo::WarpedImage Next; // output of the worker while it is busy
  bool IsNextOpen = false;  // started, but not shown yet
  std::atomic<bool> IsNextWarped{ false };
  relevo::WarpPasses Passes;

  std::atomic<int> NumberOfWarps{ 0 };
  std::atomic<double> WarpTime{ 0.0 };
  vtkTimeStamp LookTime;     // last time at which a finished image was available
  relevo::WarpWorker Worker; // last member, so that it is destroyed first

  relevo::WarpCoefficients GetCoefficients(vtkCamera* camera) const
  {
    return relevo::GetWarpCoefficients(this->Source->GetRelief(), FindEye(camera));
  }

  // Called by the thread that warps.
  void Warp(relevo::WarpedImage& image)
  {
    const auto start = std::chrono::steady_clock::now();
    this->Passes.Warp(image.GetSource(), image.GetCoefficients(), image.GetPicture());
    this->WarpTime =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    ++this->NumberOfWarps;
  }

  void Prepare(relevo::WarpedImage& image, const relevo::WarpCoefficients& coefficients,
    relevo::WarpPasses::Policy way, int numberOfThreads)
  {
    image.Prepare(this->Source, coefficients);
    this->Passes.Allocate(*this->Source, way, numberOfThreads);
  }

  void Start(const relevo::WarpCoefficients& coefficients)
  {
    this->Prepare(this->Next, coefficients, relevo::WarpPasses::Policy::OneThread, 1);
    this->IsNextOpen = true;
    this->IsNextWarped = false;
    this->Worker.Start(
      [this]
      {
        this->Warp(this->Next);
        this->IsNextWarped = true;
      });
  }

  bool IsFinished() const { return this->IsNextOpen && this->IsNextWarped; }

  void Take()
  {
    std::swap(this->Shown, this->Next);
    this->Next.Reset();
    this->IsNextOpen = false;
  }

  // Waits for the worker, so that another thread can warp.
  void Stop()
  {
    this->Worker.Wait();
    if (this->IsNextOpen)
    {
      this->Take();
    }
  }
};

vtkReliefWarper::vtkReliefWarper()
  : Own(new Internals)
{
}

vtkReliefWarper::~vtkReliefWarper() = default;

vtkCamera* vtkReliefWarper::GetCamera()
{
  return this->Camera;
}

void vtkReliefWarper::SetMaximumStretch(double stretch)
{
  relevo::SetInRange(
    this, "MaximumStretch", this->MaximumStretch, stretch, 0.0, relevo::LargestDouble);
}

void vtkReliefWarper::SetPolicy(int policy)
{
  relevo::SetChoice(this, "Policy", this->Policy, policy,
    { "SEQUENTIAL", "PARALLEL", "MULTI_THREADED", "ROWS_AND_COLUMNS" });
}

void vtkReliefWarper::SetNumberOfThreads(int number)
{
  constexpr int most = 64;
  relevo::SetInRange(this, "NumberOfThreads", this->NumberOfThreads, number, 0, most);
}

int vtkReliefWarper::GetState()
{
  if (this->Own->IsNextOpen)
  {
    return this->Own->IsFinished() ? WAITING : WARPING;
  }
  return this->Own->Shown.IsEmpty() ? INITIAL : FINAL;
}

int vtkReliefWarper::GetNumberOfWarps()
{
  return this->Own->NumberOfWarps;
}

double vtkReliefWarper::GetWarpTime()
{
  return this->Own->WarpTime;
}

bool vtkReliefWarper::CanWarp()
{
  return this->Own->Source && this->Camera && this->Own->GetCoefficients(this->Camera).IsUsable;
}

// The worker can finish at any time, even during RequestData(). The modification time increases
// until the finished image is shown.
vtkMTimeType vtkReliefWarper::GetMTime()
{
  if (this->Own->IsFinished())
  {
    this->Own->LookTime.Modified();
  }
  return std::max(relevo::GetLatestTime(this->Superclass::GetMTime(), { this->Camera }),
    this->Own->LookTime.GetMTime());
}

// Requests the whole relief.
int vtkReliefWarper::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  relevo::RequestWholeExtent(inputVector[0]->GetInformationObject(0));
  return 1;
}

int vtkReliefWarper::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* output = vtkImageData::GetData(outputVector);
  output->Initialize();
  if (!relevo::CheckInputTypes(this, inputVector))
  {
    return 0;
  }
  if (!this->Camera)
  {
    vtkErrorMacro("There is no camera: call SetCamera().");
    return 0;
  }
  bool isWarped = false;
  const auto warp = [&]
  {
    isWarped = this->Read(vtkImageData::GetData(inputVector[0]));
    if (isWarped)
    {
      this->Warp(output);
    }
  };
  if (!relevo::FitsMemory(warp))
  {
    output->Initialize();
    vtkErrorMacro("Not enough memory to warp the relief.");
    return 0;
  }
  return isWarped ? 1 : 0;
}

bool vtkReliefWarper::Read(vtkImageData* input)
{
  Internals& own = *this->Own;
  if (own.Source && own.Input == input && own.InputTime == input->GetMTime() &&
    own.Stretch == this->MaximumStretch)
  {
    return true;
  }
  auto source = std::make_shared<relevo::WarpSource>();
  const std::string wrong = source->Read(input, this->MaximumStretch);
  if (!wrong.empty())
  {
    own.Stop();
    own.Source = nullptr;
    own.Shown.Reset();
    vtkErrorMacro("The input is not a relief. " << wrong);
    return false;
  }
  own.Source = source;
  own.Input = input;
  own.InputTime = input->GetMTime();
  own.Stretch = this->MaximumStretch;
  return true;
}

void vtkReliefWarper::Warp(vtkImageData* output)
{
  using Policy = relevo::WarpPasses::Policy;
  Internals& own = *this->Own;
  const relevo::WarpCoefficients coefficients = own.GetCoefficients(this->Camera);
  if (!coefficients.IsUsable && !own.IsWarned)
  {
    vtkWarningMacro("The eye is in the relief's plane or behind it: nothing can be warped.");
  }
  own.IsWarned = !coefficients.IsUsable;
  // A change of settings always requires a warp, a change of the camera only if it has an effect.
  const vtkMTimeType settings = this->vtkObject::GetMTime();
  const auto isShown = [&]()
  { return own.WarpedSettings == settings && own.Shown.Shows(own.Source, coefficients); };

  if (this->Policy == PARALLEL)
  {
    if (own.IsFinished())
    {
      own.Take();
    }
    bool isToWait = false;
    do
    {
      if (!own.IsNextOpen && !isShown())
      {
        own.WarpedSettings = settings;
        own.Start(coefficients);
      }
      isToWait = !own.Shown.HasSizeOf(*own.Source);
      if (isToWait)
      {
        own.Stop();
      }
    } while (isToWait); // repeat if the image in progress has another size
  }
  else
  {
    own.Stop();
    if (!isShown())
    {
      own.WarpedSettings = settings;
      const int threads = this->NumberOfThreads > 0
        ? this->NumberOfThreads
        : vtkMultiThreader::GetGlobalDefaultNumberOfThreads();
      own.Prepare(own.Shown, coefficients,
        this->Policy == SEQUENTIAL         ? Policy::OneThread
          : this->Policy == MULTI_THREADED ? Policy::Bands
                                           : Policy::RowsAndColumns,
        threads);
      own.Warp(own.Shown);
    }
  }
  own.Shown.CopyTo(output);
}

void vtkReliefWarper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Camera: " << this->Camera << "\n";
  os << indent << "MaximumStretch: " << this->MaximumStretch << "\n";
  os << indent << "Policy: " << this->Policy << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "State: " << this->GetState() << "\n";
  os << indent << "NumberOfWarps: " << this->GetNumberOfWarps() << "\n";
  os << indent << "WarpTime: " << this->GetWarpTime() << "\n";
}
