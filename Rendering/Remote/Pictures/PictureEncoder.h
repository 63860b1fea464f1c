// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PictureEncoder
 * @brief   encodes one picture at a time in its own thread
 */
#ifndef PictureEncoder_h
#define PictureEncoder_h

#include "Pictures/Picture.h"

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

namespace relevo
{
class PictureEncoder
{
public:
  using Receiver = std::function<void(std::shared_ptr<const EncodedPicture>)>;

  /// The thread calls `receive` with each picture, and then `finish`, also if one was cancelled.
  PictureEncoder(Receiver receive, std::function<void()> finish);
  ~PictureEncoder();
  PictureEncoder(const PictureEncoder&) = delete;
  PictureEncoder& operator=(const PictureEncoder&) = delete;

  /// Whether no picture waits or is being encoded.
  bool IsIdle() const { return this->Idle; }
  /// The picture whose memory the next one can use. Call this only if the encoder is idle.
  RawPicture& GetPicture() { return this->Picture; }
  /// Encodes the picture. JPEG quality is from 1 to 100.
  void Start(int quality);
  /// Stops encoding a lossless picture, because there is a newer frame.
  void CancelLossless() { this->IsCancelled = true; }

private:
  void Run();
  std::shared_ptr<const EncodedPicture> Encode();

  Receiver Receive;
  std::function<void()> Finish;
  RawPicture Picture;
  int Quality = 80;
  std::atomic<bool> Idle{ true };
  std::atomic<bool> IsCancelled{ false };
  std::mutex Mutex;
  std::condition_variable Changed;
  bool HasPicture = false;
  bool IsEnding = false;
  std::thread Thread;
};
}

#endif
