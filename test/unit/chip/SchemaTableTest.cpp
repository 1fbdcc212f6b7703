//===- SchemaTableTest.cpp - The table of keys in the documentation -------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/chip/SchemaTable.h"

#include "llvm/ADT/StringRef.h"
#include "llvm/Support/MemoryBuffer.h"

#include "gtest/gtest.h"

using namespace llvm;

namespace {

TEST(SchemaTable, IsThatOfTheDocumentation) {
  std::string Table;
  raw_string_ostream OS(Table);
  tp::writeSchemaTable(OS);
  ErrorOr<std::unique_ptr<MemoryBuffer>> Page =
      MemoryBuffer::getFile(TP_CHIP_FILES_PAGE);
  ASSERT_TRUE(bool(Page));
  StringRef Rest = (*Page)->getBuffer().split("<!-- keys -->\n").second;
  EXPECT_EQ(Rest.split("<!-- end of keys -->").first.str(), Table)
      << "update it: tpsim --print-chip-schema | docs/update_chip_keys.py";
}

} // namespace
