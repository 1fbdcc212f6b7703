# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The report's experiment: its runs, what they measure, tables and charts."""
