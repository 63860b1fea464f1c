# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Times of this process, and rows of Markdown tables, for the measurements in this folder."""

import resource
import statistics
import time

from paraview.modules.vtkRemotingCore import vtkProcessModule

RANKS = vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()
RANK = vtkProcessModule.GetProcessModule().GetPartitionId()


def processor_ms():
    """The processor time of all threads of this process so far."""
    usage = resource.getrusage(resource.RUSAGE_SELF)
    return 1000 * (usage.ru_utime + usage.ru_stime)


class Times:
    """Times of actions in turn: A B A B. The first round is not counted. Other processes make frames
    longer, but do not change the processor time much."""

    def __init__(self, actions, rounds=5):
        self.walls = {name: [] for name in actions}
        self.processors = {name: [] for name in actions}
        for number in range(rounds + 1):
            for name, action in actions.items():
                processor, wall = processor_ms(), time.perf_counter()
                action(number)
                if number > 0:
                    self.walls[name].append(1000 * (time.perf_counter() - wall))
                    self.processors[name].append(processor_ms() - processor)

    def wall(self, name):
        """The median in ms."""
        return statistics.median(self.walls[name])

    def processor(self, name):
        """The median in ms."""
        return statistics.median(self.processors[name])

    def ratio(self, name, other):
        """The median over the rounds of the ratio of processor times."""
        pairs = zip(self.processors[name], self.processors[other])
        return statistics.median([one / two for one, two in pairs])


def row(*cells):
    if RANK == 0:
        print("| " + " | ".join(str(cell) for cell in cells) + " |", flush=True)
