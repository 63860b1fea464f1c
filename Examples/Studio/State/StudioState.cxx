// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "State/StudioState.h"

//------------------------------------------------------------------------------
StudioState::StudioState(const OptionValues& values)
  : Values(values)
{
}

//------------------------------------------------------------------------------
void StudioState::Set(
  const std::string& name, const std::optional<std::string>& value, bool isContinued)
{
  OptionValues values = this->Values;
  values.Choose(name, value);
  if (values == this->Values)
  {
    return;
  }
  values.Parse();
  if (!isContinued || name != this->LastName)
  {
    this->Past.push_back(this->Values);
  }
  this->Future.clear();
  this->LastName = name;
  this->Values = values;
  ++this->Version;
}

//------------------------------------------------------------------------------
void StudioState::Replace(const OptionValues& values)
{
  this->Past.push_back(this->Values);
  this->Future.clear();
  this->LastName.clear();
  this->Values = values;
  ++this->Version;
}

//------------------------------------------------------------------------------
void StudioState::Restore(const OptionValues& values)
{
  if (!this->Past.empty() && this->Past.back() == values)
  {
    this->Past.pop_back();
  }
  this->LastName.clear();
  this->Values = values;
  ++this->Version;
}

//------------------------------------------------------------------------------
void StudioState::Undo()
{
  this->Move(this->Past, this->Future);
}

//------------------------------------------------------------------------------
void StudioState::Redo()
{
  this->Move(this->Future, this->Past);
}

//------------------------------------------------------------------------------
void StudioState::Move(std::vector<OptionValues>& from, std::vector<OptionValues>& to)
{
  if (from.empty())
  {
    return;
  }
  to.push_back(this->Values);
  this->Values = from.back();
  from.pop_back();
  this->LastName.clear();
  ++this->Version;
}
