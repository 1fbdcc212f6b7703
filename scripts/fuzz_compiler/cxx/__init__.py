# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Random C++ programs without undefined behaviour, for what csmith lacks."""
