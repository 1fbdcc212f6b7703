# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""How a search ends without a culprit."""


class UserError(Exception):
    """The request cannot be carried out; the text says why and what helps."""


class NothingToFind(Exception):
    """Good and bad do not differ; the text says in what way."""
