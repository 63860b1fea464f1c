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


class MessageCatcher:
    """Collects the errors and warnings of an object, each of which a test has to expect."""

    def __init__(self, item):
        self.messages = []

        def catch(caller, event, message):
            self.messages.append(message)

        catch.CallDataType = "string0"
        for event in ("ErrorEvent", "WarningEvent"):
            item.AddObserver(event, catch)

    def expect(self, words):
        """Checks that one message has these words, and forgets it."""
        found = [message for message in self.messages if words in message]
        assert len(found) == 1, (words, self.messages)
        self.messages.remove(found[0])

    def check(self, test):
        test.assertEqual(self.messages, [])
