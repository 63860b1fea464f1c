// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   OpenImageIORaster
 * @brief   first channel of a raster, read with OpenImageIO
 *
 * Private to the module.
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
   * Returns nullptr with an `error` if OpenImageIO cannot read the file or would convert its
   * samples.
   */
  static std::unique_ptr<OpenImageIORaster> Open(const std::string& fileName, std::string& error);

  OpenImageIORaster();
  ~OpenImageIORaster() override;

  /**
   * Uses another reader of the same file for its description, for rows that OpenImageIO cannot read
   * (empty blocks of sparse files), and for its overviews. Returns false if size or type differ.
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
