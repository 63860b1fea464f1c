// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ClientConnection
 * @brief   sends pictures to one client
 *
 * A client confirms each picture that it has shown. At most two pictures are unconfirmed: one that
 * the client shows, and one on its way. So a slow client gets fewer pictures, and they are not out
 * of date. A thread waits for the network.
 */
#ifndef ClientConnection_h
#define ClientConnection_h

#include "Pictures/Picture.h"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

namespace relevo
{
class ClientConnection
{
public:
  /// Sends a message of this size in bytes. nullptr requests the end of the connection. Returns
  /// false if the client cannot be reached.
  using Sender = std::function<bool(const unsigned char*, std::size_t)>;

  ClientConnection(int number, Sender send);
  ~ClientConnection();
  ClientConnection(const ClientConnection&) = delete;
  ClientConnection& operator=(const ClientConnection&) = delete;

  int GetNumber() const { return this->Number; }

  /// Whether the client can take another picture, and has not got this frame; with `isLossless`,
  /// whether it has not got it without loss.
  bool Wants(std::uint64_t frame, bool isLossless) const;
  /// Whether the client has not got this frame without loss, even if it cannot take it now.
  bool Lacks(std::uint64_t frame) const;
  /// Sends the picture if Wants() is true. Returns whether it does.
  bool Send(const std::shared_ptr<const EncodedPicture>& picture);
  /// The client has shown a picture.
  void Confirm();
  /// Asks the client to end the connection, after the pictures that are being sent.
  void Leave();

  /// Whether a picture could not be sent.
  bool IsBroken() const { return this->Broken; }
  /// Counts a malformed message and returns the number of those so far.
  int CountMalformed() { return ++this->NumberOfMalformed; }
  int GetNumberOfMalformed() const { return this->NumberOfMalformed; }

private:
  bool CanTake(std::uint64_t frame, bool isLossless) const;
  void Run();

  const int Number;
  Sender SendData;
  mutable std::mutex Mutex;
  std::condition_variable Changed;
  std::shared_ptr<const EncodedPicture> Waiting;
  std::uint64_t Frame = 0; // the newest that was sent
  bool IsLossless = false;
  int NumberOfUnconfirmed = 0;
  bool IsLeaving = false;
  bool IsEnding = false;
  std::atomic<bool> Broken{ false };
  int NumberOfMalformed = 0; // only the thread that reads uses it
  std::thread Thread;
};
}

#endif
