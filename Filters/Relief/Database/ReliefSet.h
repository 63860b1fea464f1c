// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReliefSet
 * @brief   writes the files of a database, which replaces an old one atomically
 *
 * New files have temporary names until Commit(). The folder contains the old database until
 * Commit() renames the new table to the name of the old one. At any moment, all rows of the table
 * have their files.
 *
 * Private to the module.
 */
#ifndef ReliefSet_h
#define ReliefSet_h

#include "Database/ReliefColumns.h"
#include "Files/AtomicFile.h"

#include <deque>
#include <filesystem>
#include <string>
#include <vector>

namespace relevo
{
struct ReliefBlock;

class ReliefSet
{
public:
  /// Creates the folder if necessary, for up to maximumReliefs reliefs.
  ReliefSet(const std::string& folder, std::size_t maximumReliefs, bool hasPictures);
  /// Removes files that were not committed.
  ~ReliefSet();
  ReliefSet(const ReliefSet&) = delete;
  void operator=(const ReliefSet&) = delete;

  /// Returns why a database cannot be written to the folder, as a sentence, or "". A folder must be
  /// empty or contain a database of reliefs.
  const std::string& GetError() const { return this->Error; }

  /// Writes the files of a relief. Returns false with GetError() if that fails.
  bool Add(const ReliefBlock& block);

  /// Replaces the old database. Returns false with GetError() if that fails.
  bool Commit();

private:
  std::filesystem::path GetPath(std::size_t number, const std::string& extension) const;
  std::string FormatTable(std::size_t firstNumber) const;
  bool RenameFiles();
  void RemoveFiles(std::size_t firstNumber);
  void RemoveOldFiles();
  bool LinkFiles(std::size_t to);
  void Renumber();

  std::filesystem::path Folder;
  std::vector<std::string> Extensions;
  std::string Error;
  bool IsFolderNew = false;
  std::size_t FirstNumber = 0;
  std::vector<ReliefParameters> Reliefs; // without the columns of files
  std::deque<AtomicFile> Files;          // one per extension and relief
};
}

#endif
