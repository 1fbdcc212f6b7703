//===- ExecutionRecorder.h - Records a run for its profile ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// What a thread does in a function is the difference of its counts between two
// changes of the function. So only calls, returns and jumps between functions
// are observed, whose handlers are the interpreter's; all else may be generated
// code.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_EXECUTIONRECORDER_H
#define TP_SIMULATOR_CORE_EXECUTIONRECORDER_H

#include "simulator/chip/ChipConfig.h"
#include "simulator/core/Archive.h"
#include "simulator/core/CallTree.h"
#include "simulator/core/FunctionMap.h"
#include "simulator/core/Thread.h"
#include "simulator/stats/ExecutionRecord.h"

#include <deque>
#include <span>
#include <vector>

namespace tp {

/// An instruction that has been issued.
struct IssuedInstruction {
  uint32_t Word = 0;
  /// The next one that the thread comes to.
  uint32_t NextWord = 0;
  bool IsTaken = false;
  /// The cycle after that of issue.
  uint64_t Cycle = 0;
  /// What the thread will be charged for the branch.
  uint64_t BranchLoss = 0;
};

/// A request to the memory system that has been answered.
struct AnsweredRequest {
  uint32_t Thread = 0;
  /// Its instruction.
  uint32_t Word = 0;
  uint64_t Issued = 0;
  uint64_t Ready = 0;
  ServedBy Level = ServedBy::Memory;
};

/// What was counted in a node of the call tree, and by word of the text.
struct RecordedCounts {
  struct NodeCounts {
    uint64_t Calls = 0;
    uint64_t Instructions = 0;
    LossCounts Lost{};
  };

  explicit RecordedCounts(size_t NumWords) : Served(NumWords) {}

  NodeCounts &of(uint32_t Node) {
    if (Node >= Nodes.size())
      Nodes.resize(Node + 1);
    return Nodes[Node];
  }
  RecordedCounts &operator+=(const RecordedCounts &Other);
  void serialize(Archive &A) {
    A(Nodes);
    A(Served);
  }

  std::vector<NodeCounts> Nodes;
  std::vector<std::array<ServedAccesses, NumServedBy>> Served;
};

class ExecutionRecorder;

/// What one host thread records.
class RecorderPart {
public:
  RecorderPart(ExecutionRecorder &Owner, size_t NumWords)
      : Owner(Owner), Counts(NumWords) {}

  /// A thread has issued an instruction that is observed.
  void issued(const Thread &T, const IssuedInstruction &Issued);
  /// A request has been answered.
  void served(const AnsweredRequest &Answer);

private:
  friend ExecutionRecorder;

  ExecutionRecorder &Owner;
  std::vector<AnsweredRequest> Answers;
  RecordedCounts Counts;
};

/// Records what the statistics do not have: the tree of calls, and where the
/// accesses of each instruction were served. It changes nothing in the run.
class ExecutionRecorder {
public:
  /// \p Chip and \p Text must outlive it. Functions begin at \p Entries, words
  /// of the text.
  ExecutionRecorder(const ChipConfig &Chip, const Program &Text,
                    std::vector<uint32_t> Entries);

  /// Whether RecorderPart::issued() must be told of the instruction.
  bool isObserved(uint32_t Word) const {
    return Transfers[Word] != Transfer::None;
  }

  /// Also keeps the answers to requests of a thread that are under way in
  /// cycles from \p First to before \p End, which are the same for all threads.
  void traceRequests(uint32_t Thread, uint64_t First, uint64_t End);
  /// Those that were kept, in no order.
  std::vector<AnsweredRequest> tracedRequests() const;

  // What an engine calls.

  /// A thread will begin at this word.
  void begin(const Thread &T, uint32_t Word);
  bool hasBegun() const { return !Threads.empty(); }
  /// A part for another host thread; it stays where it is.
  RecorderPart &addPart() {
    return Parts.emplace_back(*this, Transfers.size());
  }

  /// What was recorded up to now, where the run has these statistics.
  ExecutionRecord record(const Statistics &Now) const;

  /// Between two windows; but for requests that are traced.
  void serialize(Archive &A);

private:
  friend RecorderPart;

  /// A call that a thread has not come back from.
  struct OpenCall {
    uint32_t ReturnWord;
    uint32_t Caller;
  };
  /// Where a thread is.
  struct ThreadCalls {
    uint32_t Node = CallTree::NoNode;
    /// Before the last change of Node.
    uint32_t LastNode = CallTree::NoNode;
    /// The counts up to which it has been accounted for.
    uint64_t Instructions = 0;
    LossCounts Lost{};
    std::vector<OpenCall> Stack;

    void serialize(Archive &A) {
      A(Node);
      A(LastNode);
      A(Instructions);
      A(Lost);
      A(Stack);
    }
  };

  void call(ThreadCalls &Where, const IssuedInstruction &Issued,
            RecorderPart &Part);
  void comeBack(ThreadCalls &Where, uint32_t Word, RecorderPart &Part);
  void jump(ThreadCalls &Where, const IssuedInstruction &Issued,
            RecorderPart &Part);
  void enter(ThreadCalls &Where, const CallTree::Node &Function,
             RecorderPart &Part);
  /// Of all parts.
  RecordedCounts total() const;
  /// Adds to \p Sum what threads have done since they came to their nodes.
  void addOpenNodes(const Statistics &Now, RecordedCounts &Sum) const;
  void recordAccesses(const Statistics &Now, const RecordedCounts &Sum,
                      ExecutionRecord &Result) const;
  void recordCalls(const RecordedCounts &Sum, ExecutionRecord &Result) const;

  const ChipConfig &Chip;
  const Program &Text;
  const FunctionMap Functions;
  const std::vector<Transfer> Transfers;
  /// Of all threads whether their requests are kept; empty for none.
  std::vector<bool> IsTraced;
  uint64_t FirstTraced = 0;
  uint64_t EndOfTraced = 0;
  CallTree Tree;
  std::vector<ThreadCalls> Threads;
  std::deque<RecorderPart> Parts;
};

} // namespace tp

#endif // TP_SIMULATOR_CORE_EXECUTIONRECORDER_H
