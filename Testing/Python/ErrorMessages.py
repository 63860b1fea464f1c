# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""What objects say of errors."""


def catch_errors(item):
    """The messages of an object's ErrorEvents, from now on."""
    messages = []

    def catch(caller, event, message):
        messages.append(message)

    catch.CallDataType = "string0"
    item.AddObserver("ErrorEvent", catch)
    return messages
