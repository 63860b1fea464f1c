// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MapperMessages
 * @brief   passes the errors and warnings of a mapper to a representation, in ParaView's words
 *
 * Private to the module.
 */
#ifndef MapperMessages_h
#define MapperMessages_h

#include "MapperMessage.h"
#include "vtkWeakPointer.h"

#include <array>
#include <functional>
#include <string>

class vtkObject;

namespace relevo
{
class MapperMessages
{
public:
  using Function = std::function<void(bool isError, const std::string& message)>;

  /// Set the function that reports a message, and the words to replace in it.
  explicit MapperMessages(Function report, MapperWords words = {});
  ~MapperMessages();
  MapperMessages(const MapperMessages&) = delete;
  void operator=(const MapperMessages&) = delete;

  /// Observe a mapper instead of the previous one. Its progress is not shown: ParaView's window
  /// would make its OpenGL context current while the mapper draws.
  void Observe(vtkObject* mapper);

private:
  void Stop();
  void Pass(vtkObject* mapper, unsigned long event, void* text);

  Function Report;
  MapperWords Words;
  vtkWeakPointer<vtkObject> Mapper;
  std::array<unsigned long, 2> Tags = { { 0, 0 } }; // of the observers
};
}

#endif
