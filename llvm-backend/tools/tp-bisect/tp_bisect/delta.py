# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Searches for what makes a test fail, several tests at a time.

`judge_all(candidates)` says for each candidate whether it is bad: True, False,
or None if that cannot be said. It may test them in parallel.
"""

from bisect import bisect_left
from itertools import accumulate


def first_bad_step(low, high, ways, judge_all, weigh=lambda step: 1):
    """The N in (low, high] with N-1 good and N bad, if low is good and high is
    bad; `ways` steps are asked for at a time. `weigh` says how likely a step is
    to be N: the likelier, the sooner it is found.

    Returns N and the greatest step below it that is known to be good: not N-1
    if the steps between cannot be judged.
    """
    reached = list(accumulate((weigh(s) for s in range(low + 1, high + 1)), initial=0))
    begin = low
    unknown = set()
    while True:
        between = [s for s in range(low + 1, high) if s not in unknown]
        if not between:
            return high, low
        least, most = reached[low - begin], reached[high - begin]
        steps = set()
        for part in range(1, ways + 1):
            wanted = least + (most - least) * part / (ways + 1)
            place = begin + bisect_left(reached, wanted)
            steps.add(between[min(bisect_left(between, place), len(between) - 1)])
        for step, is_bad in zip(sorted(steps), judge_all(sorted(steps))):
            if is_bad is None:
                unknown.add(step)
            elif is_bad:
                high = step
                break
            else:
                low = step


def minimize(items, ways, judge_all):
    """A subset of `items`, which together are bad while without all of them it is good,
    that is bad and from which no item can be left out.

    The last item of the shortest bad prefix is guilty; so is, with those that
    are known, the last of the next shortest one, until the known ones are
    enough. One guilty item of n takes a logarithm of n tests.
    """
    items = list(items)
    guilty = []
    while items:
        known = tuple(guilty)

        def judge_prefixes(lengths):
            return judge_all([[*items[:n], *known] for n in lengths])

        if guilty and judge_prefixes([0])[0]:
            break
        length, _ = first_bad_step(0, len(items), ways, judge_prefixes)
        guilty.insert(0, items[length - 1])
        items = items[: length - 1]
    return _without_innocent(guilty, judge_all)


def _without_innocent(items, judge_all):
    """Leaves out, one by one, what is not needed to be bad."""
    place = 0
    while len(items) > 1 and place < len(items):
        rest = items[:place] + items[place + 1 :]
        if judge_all([rest])[0]:
            items = rest
        else:
            place += 1
    return items
