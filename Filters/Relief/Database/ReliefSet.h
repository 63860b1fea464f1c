// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReliefSet
 * @brief   the files of a new database, which replace those of the old one together
 *
 * A folder has the old database until Commit() renames the new table onto the old one, and then the
 * new database: at every moment each row of the table has its file. Until Commit() the new files
 * have temporary names.
 *
 * Private to the module's own sources.
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
  /// In a folder, which is made if there is none, of up to as many reliefs.
  ReliefSet(const std::string& folder, std::size_t maximumReliefs, bool hasPictures);
  /// Remove what was not committed.
  ~ReliefSet();
  ReliefSet(const ReliefSet&) = delete;
  void operator=(const ReliefSet&) = delete;

  /// Why there cannot be a database in the folder, a sentence, or "". A folder has to be empty, or
  /// to have a database of reliefs.
  const std::string& GetError() const { return this->Error; }

  /// Write the files of a relief; false, with the fault, if that failed.
  bool Add(const ReliefBlock& block);

  /// Replace the old database; false, with the fault, if that failed.
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
  std::vector<ReliefParameters> Reliefs; // without their files
  std::deque<AtomicFile> Files;          // as many as extensions for each relief
};
}

#endif
