// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// A library of the project itself.
int GetOwnNumber()
{
  return 16;
}
