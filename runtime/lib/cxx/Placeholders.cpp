//===- Placeholders.cpp - Arguments of std::bind --------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include <functional>

namespace std::placeholders {

#define TP_PLACEHOLDER(Number) const _Placeholder<Number> _##Number{};
TP_PLACEHOLDER(1)
TP_PLACEHOLDER(2)
TP_PLACEHOLDER(3)
TP_PLACEHOLDER(4)
TP_PLACEHOLDER(5)
TP_PLACEHOLDER(6)
TP_PLACEHOLDER(7)
TP_PLACEHOLDER(8)
TP_PLACEHOLDER(9)
TP_PLACEHOLDER(10)
TP_PLACEHOLDER(11)
TP_PLACEHOLDER(12)
TP_PLACEHOLDER(13)
TP_PLACEHOLDER(14)
TP_PLACEHOLDER(15)
TP_PLACEHOLDER(16)
TP_PLACEHOLDER(17)
TP_PLACEHOLDER(18)
TP_PLACEHOLDER(19)
TP_PLACEHOLDER(20)
TP_PLACEHOLDER(21)
TP_PLACEHOLDER(22)
TP_PLACEHOLDER(23)
TP_PLACEHOLDER(24)
TP_PLACEHOLDER(25)
TP_PLACEHOLDER(26)
TP_PLACEHOLDER(27)
TP_PLACEHOLDER(28)
TP_PLACEHOLDER(29)

} // namespace std::placeholders
