//===- ProfileTable.h - A profile for people --------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_PROFILE_PROFILETABLE_H
#define TP_SIMULATOR_PROFILE_PROFILETABLE_H

#include "simulator/profile/Profile.h"

#include "llvm/ADT/StringRef.h"
#include "llvm/Support/raw_ostream.h"

#include <optional>
#include <string>
#include <vector>

namespace tp {

/// What a row of the table is about.
enum class ProfileRows {
  /// A line of the source.
  Line,
  /// A function of the source, wherever it was inlined.
  Function,
  /// A function with what it was inlined into and called through.
  Path,
  /// One instruction.
  Instruction,
};

/// What the largest is first of: one loss, the accesses that one level served,
/// or if there is neither a sum.
struct ProfileOrder {
  enum SumKind { Cycles, Instructions, MemoryWaits, Global, Latency };

  SumKind Sum = Cycles;
  std::optional<Loss> Reason;
  std::optional<ServedBy> Level;
};

/// The rows and orders as options name them.
std::optional<ProfileRows> findProfileRows(llvm::StringRef Name);
std::optional<ProfileOrder> findProfileOrder(llvm::StringRef Name);
/// All names that findProfileOrder() knows.
std::vector<std::string> profileOrderNames();

/// How the table is to be.
struct ProfileTableOptions {
  ProfileRows Rows = ProfileRows::Line;
  ProfileOrder Order;
  size_t MaxRows = 16;
};

/// Counts of one row.
struct ProfileRow {
  std::string Name;
  ProfileCounts Counts;
  MemoryBehaviour Memory;
};

/// All rows in this order; equal ones by name. Their sum is the profile's.
std::vector<ProfileRow> profileRows(const Profile &Data, ProfileRows Rows,
                                    const ProfileOrder &Order);

/// Writes the first rows, and the rest as one row.
void writeProfileTable(const Profile &Data, const ProfileTableOptions &Options,
                       llvm::raw_ostream &OS);

} // namespace tp

#endif // TP_SIMULATOR_PROFILE_PROFILETABLE_H
