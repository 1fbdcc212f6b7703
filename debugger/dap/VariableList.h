//===- VariableList.h - What a client can unfold ----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_VARIABLELIST_H
#define TP_DEBUGGER_DAP_VARIABLELIST_H

#include "llvm/ADT/StringRef.h"
#include "llvm/Support/Error.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tp::dap {

class VariableList;

/// A line of a list: a name, a value and perhaps parts of it.
struct VariableRow {
  std::string Name;
  std::string Value;
  std::string Type;
  /// The expression that gives the same value; empty if there is none.
  std::string Expression;
  /// Where it is in memory.
  std::optional<uint32_t> Address;
  bool IsReadOnly = false;
  /// Nothing if it has no parts.
  std::shared_ptr<VariableList> Parts;
};

/// How a client wants values.
struct ValueFormat {
  bool Hex = false;
};

/// The variables of a scope, or the parts of a value. Its frame is that of a
/// stop and must not be used after the program has moved.
class VariableList {
public:
  virtual ~VariableList();

  virtual uint32_t count() const = 0;
  /// Whether these are elements by number, of which a client asks for a few.
  virtual bool isIndexed() const { return false; }
  /// Rows \p First to \p First + \p Count, as far as there are so many.
  virtual llvm::Expected<std::vector<VariableRow>>
  rows(uint32_t First, uint32_t Count, ValueFormat Format) const = 0;
};

/// Rows that do not change while the program stands.
class FixedList : public VariableList {
public:
  explicit FixedList(std::vector<VariableRow> Rows) : Rows(std::move(Rows)) {}

  uint32_t count() const override { return uint32_t(Rows.size()); }
  llvm::Expected<std::vector<VariableRow>>
  rows(uint32_t First, uint32_t Count, ValueFormat Format) const override;

private:
  std::vector<VariableRow> Rows;
};

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_VARIABLELIST_H
