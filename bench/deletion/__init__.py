# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The picture of a deletion: the cache's slots as the report's table, and the
tree that they hold, before and after."""
