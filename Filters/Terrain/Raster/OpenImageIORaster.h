// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   OpenImageIORaster
 * @brief   a raster's first channel through OpenImageIO
 *
 * Private to the module's own sources.
 */
#ifndef OpenImageIORaster_h
#define OpenImageIORaster_h

#include "Raster/Raster.h"

namespace relevo
{
class OpenImageIORaster : public Raster
{
public:
  /**
   * nullptr, and why in `error`, when OpenImageIO cannot read the file or would change its
   * samples.
   */
  static std::unique_ptr<OpenImageIORaster> Open(const std::string& fileName, std::string& error);

  OpenImageIORaster();
  ~OpenImageIORaster() override;

  /**
   * Takes over what another reader says of the same file and turns to it for rows that
   * OpenImageIO cannot read (the empty blocks of sparse files), and for smaller versions that it
   * knows. False when the two disagree on size or type.
   */
  bool SetAlternative(std::unique_ptr<Raster>& alternative);

  void SelectLevel(int width, int height) override;
  bool ReadRows(int first, int count, void* samples, std::string& error) override;

private:
  struct Internals;
  std::unique_ptr<Internals> Implementation;
  std::unique_ptr<Raster> Alternative;
};
}

#endif
