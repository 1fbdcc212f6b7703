#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# Random programs of all instructions on random chips: the reference engine and
# generated code against the independent model (test/unit/oracle), many more than
# in the test suite:
#   scripts/oracle-campaign.sh [programs of each kind] [first seed]
# 10,000 programs from seed 1 if nothing else is said: about half an hour on two
# cores, nearly all of it for generating code. Exit status 1 if anything differs.
set -euo pipefail
cd "$(dirname "$0")/.."
export TP_ORACLE_PROGRAMS="${1:-10000}" TP_ORACLE_SEED="${2:-1}"
status=0
build/bin/oracle-test --gtest_brief=1 &
build/bin/oracle-jit-test --gtest_brief=1 || status=1
wait $! || status=1
exit "$status"
