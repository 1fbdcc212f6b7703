# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Prints a C++ file that compiles if bench/experiment knows the layout."""

from experiment.configurations import FORMATS, Kernel
from experiment.measures import TRIANGLE_BYTES

print('#include "kernels/treecache/SlotFormat.h"')
print(f"static_assert(tp::kTriangleTestBytes == {TRIANGLE_BYTES});")
for slot_format in FORMATS:
    size = Kernel("HighestBranch", slot_format).node_bytes
    print(f"static_assert(tp::{slot_format}::NodeBytes == {size});")
print(f"static_assert(tp::FullSlots::NodeBytes == {Kernel().node_bytes});")
