# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Compiles each of the C++ library's headers alone: library_headers.py <tpcc>.

One compilation reads them all, in an order and in its reverse, so that each
comes before every other once.
"""

import subprocess
import sys

SINCE = {
    "c++11": """algorithm array atomic bitset cassert cctype cerrno cfenv cfloat
        cinttypes climits cmath complex csetjmp cstdarg cstddef cstdint cstdio
        cstdlib cstring deque exception forward_list functional
        initializer_list iterator limits complex.h fenv.h list map math.h memory new numeric
        queue random ratio set setjmp.h stack stdlib.h string tuple type_traits
        typeindex unordered_map unordered_set utility valarray vector""",
    "c++17": "any charconv chrono optional string_view variant",
    "c++20": """barrier bit compare concepts coroutine latch numbers ranges
        source_location span version""",
    "c++23": "expected stdatomic.h",
}


def compile_headers(tpcc, standard, headers):
    source = "".join(f"#include <{header}>\n" for header in headers)
    command = [tpcc, f"-std={standard}", "-Wall", "-Wextra", "-Werror",
               "-fsyntax-only", "-x", "c++", "-"]
    result = subprocess.run(command, input=source, capture_output=True,
                            text=True)
    if result.returncode != 0:
        sys.exit(f"{standard}:\n{result.stderr}")


def main():
    tpcc = sys.argv[1]
    headers = []
    for standard, names in SINCE.items():
        headers += names.split()
        compile_headers(tpcc, standard, headers)
        compile_headers(tpcc, standard, reversed(headers))


if __name__ == "__main__":
    main()
