# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Finds the flag, function, pass and instruction that break a program."""
