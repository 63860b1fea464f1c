// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pictures/PictureEncoder.h"

#include "Pictures/PictureFormats.h"

#include <utility>

namespace relevo
{
//------------------------------------------------------------------------------
PictureEncoder::PictureEncoder(Receiver receive, std::function<void()> finish)
  : Receive(std::move(receive))
  , Finish(std::move(finish))
  , Thread([this] { this->Run(); })
{
}

//------------------------------------------------------------------------------
PictureEncoder::~PictureEncoder()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->IsEnding = true;
    this->IsCancelled = true;
  }
  this->Changed.notify_one();
  this->Thread.join();
}

//------------------------------------------------------------------------------
void PictureEncoder::Start(int quality)
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Quality = quality;
    this->HasPicture = true;
    this->IsCancelled = false;
    this->Idle = false;
  }
  this->Changed.notify_one();
}

//------------------------------------------------------------------------------
void PictureEncoder::Run()
{
  for (;;)
  {
    {
      std::unique_lock<std::mutex> lock(this->Mutex);
      this->Changed.wait(lock, [this] { return this->HasPicture || this->IsEnding; });
      if (this->IsEnding)
      {
        return;
      }
      this->HasPicture = false;
    }
    if (std::shared_ptr<const EncodedPicture> encoded = this->Encode())
    {
      this->Receive(std::move(encoded));
    }
    this->Idle = true;
    this->Finish();
  }
}

//------------------------------------------------------------------------------
std::shared_ptr<const EncodedPicture> PictureEncoder::Encode()
{
  auto encoded = std::make_shared<EncodedPicture>();
  encoded->Frame = this->Picture.Frame;
  encoded->IsLossless = this->Picture.IsLossless;
  encoded->Data = encoded->IsLossless ? WritePNG(this->Picture, this->IsCancelled)
                                      : WriteJPEG(this->Picture, this->Quality);
  return encoded->Data.empty() ? nullptr : encoded;
}
}
