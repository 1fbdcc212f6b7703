# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Unwinds the stack at every instruction of a run by .debug_frame and compares
with the calls that the run has made:

    check_unwinding.py <program> <trace>

The trace is from tpsim --trace-instructions.
"""

import re
import sys

from dwarf import FrameTable
from replay import RETURN_ADDRESS, STACK_POINTER, Thread, unwind

SAVED = [*range(16, 24), 30, *range(52, 64)]


class Call:
    """A caller at its call: its registers and where it goes on."""

    def __init__(self, registers, return_address):
        self.registers, self.return_address = registers, return_address


def is_return(text):
    return re.match(r"jr\s+r31", text)


def difference(thread, frames, call):
    """What is wrong with the unwound frame, or None."""
    row = frames.at(thread.pc)
    if row is None:
        return "no frame information"
    caller, return_address = unwind(thread.registers, thread.word, row)
    if return_address != call.return_address:
        return (
            f"return address {return_address:#x}, "
            f"not {call.return_address:#x}"
        )
    for register in [STACK_POINTER, *SAVED]:
        if caller[register] != call.registers[register]:
            return (
                f"register {register} of the caller is "
                f"{caller[register]:#x}, not {call.registers[register]:#x}"
            )
    return None


def check(program, trace):
    """The numbers of instructions and of addresses, and what was wrong."""
    thread, frames = Thread(program), FrameTable(program)
    calls, checked, failures, addresses = [], 0, [], set()
    previous, caller = None, None
    for pc in thread.follow(trace):
        if caller:
            calls.append(Call(caller, previous + 4))
        elif previous and is_return(thread.instructions[previous]) and calls:
            calls.pop()
        if calls:
            wrong = difference(thread, frames, calls[-1])
            if wrong and pc not in addresses:
                failures.append(f"{pc:#x} ({thread.instructions[pc]}): {wrong}")
            checked += 1
            addresses.add(pc)
        is_call = re.match(r"jalr?\s", thread.instructions[pc])
        previous, caller = pc, list(thread.registers) if is_call else None
    return checked, addresses, failures


def main():
    checked, addresses, failures = check(sys.argv[1], sys.argv[2])
    for failure in failures[:20]:
        print(failure)
    print(
        f"unwound at {checked} instructions, {len(addresses)} addresses: "
        f"{len(failures)} wrong"
    )
    sys.exit(1 if failures or not checked else 0)


if __name__ == "__main__":
    main()
