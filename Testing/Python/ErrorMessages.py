# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Collects error messages of objects."""


def catch_errors(item):
    """Returns a list that receives the messages of an object's ErrorEvents from now on."""
    messages = []

    def catch(caller, event, message):
        messages.append(message)

    catch.CallDataType = "string0"
    item.AddObserver("ErrorEvent", catch)
    return messages
