# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""The exception for errors of Relevo and VTK."""


class Error(RuntimeError):
    """An error of Relevo or VTK, with the text of its ErrorEvent."""


Error.__module__ = "relevo"
