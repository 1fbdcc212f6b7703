//===- CacheTrace.cpp - A deletion in a cache of the BVH ------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/CacheTrace.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/Support/FormatVariadic.h"
#include "llvm/Support/JSON.h"

#include <array>
#include <cstddef>

using namespace llvm;

namespace tp {

using References = std::array<BvhReference, kWideBvhWidth>;

namespace {

/// The nodes in memory of the kind that the cache holds.
class NodesInMemory {
public:
  NodesInMemory(const CacheShape &Shape, const LaunchBlock &Launch,
                const LaunchMemory &Memory)
      : Memory(Memory), ChildOffset(Shape.ChildOffset) {
    SceneHeader Header;
    Memory.read(Launch.Scene, &Header, sizeof(Header));
    bool IsFull = ChildOffset == offsetof(WideBvhNode, Child);
    NodeBytes = IsFull ? sizeof(WideBvhNode) : sizeof(QuantizedBvhNode);
    Begin = Launch.Scene +
            (IsFull ? Header.NodesOffset : Header.QuantizedNodesOffset);
    Count = Header.NodeCount;
  }

  /// The children of the node at \p Node; std::nullopt if there is none.
  std::optional<References> childrenOf(BvhReference Node) const {
    if (ChildOffset + sizeof(References) > NodeBytes || Node % NodeBytes != 0 ||
        Node / NodeBytes >= Count)
      return std::nullopt;
    References Children;
    Memory.read(Begin + Node + ChildOffset, Children.data(), sizeof(Children));
    return Children;
  }

private:
  const LaunchMemory &Memory;
  const uint32_t ChildOffset;
  uint32_t NodeBytes;
  DeviceAddress Begin;
  uint32_t Count;
};

} // namespace

/// Whether \p Reference, the child of a node, stands for a missing one.
static bool isNothing(BvhReference Reference) {
  return isLeaf(Reference) && leafCount(Reference) == 0;
}

static TracedPointer makePointer(uint16_t Slot, BvhReference Reference) {
  if (Slot != CacheMirror::None)
    return {TracedPointer::InSlot, Slot, Reference};
  if (isNothing(Reference))
    return {};
  return {TracedPointer::InMemory, 0, Reference};
}

static Expected<std::vector<TracedSlot>>
traceSlots(const CacheMirror &Cache, const DeletionRecord &Record,
           const NodesInMemory &Nodes) {
  std::vector<TracedSlot> Traced;
  for (const CacheMirror::Slot &Slot : Cache.slots()) {
    TracedSlot &T = Traced.emplace_back();
    T.Loaded = Slot.Is != CacheMirror::Slot::Free;
    if (!T.Loaded)
      continue;
    T.IsLeaf = Slot.Is == CacheMirror::Slot::Leaf;
    T.OnPath = is_contained(Record.Path, Traced.size() - 1);
    T.Depth = Slot.Depth;
    T.Parent = Slot.Parent;
    T.Source = Slot.Source;
    if (T.IsLeaf) {
      BvhReference Rest = Cache.restOf(Slot);
      T.Pointers.push_back(makePointer(
          Slot.Children[0], Rest == kNoRest ? leafReference(0, 0) : Rest));
      continue;
    }
    std::optional<References> Children = Nodes.childrenOf(Slot.Source);
    if (!Children)
      return createStringError(
          formatv("--trace-cache: slot {0} was loaded from {1:x8}, where the "
                  "scene has no node",
                  Traced.size() - 1, Slot.Source)
              .str());
    for (auto [Child, Reference] : zip_equal(Slot.Children, *Children))
      T.Pointers.push_back(makePointer(Child, Reference));
  }
  return Traced;
}

Expected<CacheTrace> traceDeletion(const DeletionRequest &Which,
                                   const DeletionRecord &Record,
                                   const LaunchBlock &Launch,
                                   const LaunchMemory &Memory) {
  NodesInMemory Nodes(Record.Before.shape(), Launch, Memory);
  CacheTrace Trace{Which, &Record, {}, {}};
  for (auto [Cache, Slots] : {std::pair(&Record.Before, &Trace.Before),
                              std::pair(&Record.After, &Trace.After)}) {
    Expected<std::vector<TracedSlot>> Traced =
        traceSlots(*Cache, Record, Nodes);
    if (!Traced)
      return Traced.takeError();
    *Slots = std::move(*Traced);
  }
  return Trace;
}

static std::string pointerText(const TracedPointer &Pointer) {
  switch (Pointer.To) {
  case TracedPointer::InSlot:
    return "-> " + std::to_string(Pointer.Slot);
  case TracedPointer::InMemory:
    return "<unloaded>";
  case TracedPointer::Nothing:
    return "<empty>";
  }
  llvm_unreachable("every pointer has a text");
}

static void writeSlots(ArrayRef<TracedSlot> Slots, raw_ostream &OS) {
  constexpr const char *Row = "{0,5}  {1,-6}  {2,-12}{3}";
  OS << formatv(Row, "INDEX", "LOADED", "TYPE", "POINTERS") << '\n';
  for (auto [Index, Slot] : enumerate(Slots)) {
    std::string Pointers;
    for (const TracedPointer &Pointer : Slot.Pointers)
      Pointers += formatv("{0,-11}", pointerText(Pointer));
    if (Slot.OnPath)
      Pointers += "<-";
    const char *Type = Slot.IsLeaf ? "Leaf" : "Interior";
    std::string Line = formatv(Row, Index, Slot.Loaded ? "1" : "-",
                               Slot.Loaded ? Type : "<empty>", Pointers);
    OS << StringRef(Line).rtrim() << '\n';
  }
}

void writeTable(const CacheTrace &Trace, raw_ostream &OS) {
  const DeletionRecord &Record = *Trace.Record;
  OS << formatv("thread {0}, ray {1}: before deletion {2}\n",
                Trace.Which.Thread, Record.Ray, Trace.Which.Deletion);
  writeSlots(Trace.Before, OS);
  OS << formatv("\nafter deletion {0}, which freed {1} slots:",
                Trace.Which.Deletion, Record.Freed.size());
  for (uint16_t Slot : Record.Freed)
    OS << ' ' << Slot;
  OS << '\n';
  writeSlots(Trace.After, OS);
  OS << '\n';
}

static const char *typeName(BvhReference Reference) {
  return isLeaf(Reference) ? "leaf" : "interior";
}

static std::string hexadecimal(uint32_t Value) {
  return formatv("0x{0:X-8}", Value).str();
}

static json::Object pointerJson(const TracedPointer &Pointer) {
  switch (Pointer.To) {
  case TracedPointer::InSlot:
    return json::Object{{"to", "slot"}, {"slot", Pointer.Slot}};
  case TracedPointer::InMemory:
    return json::Object{{"to", "memory"},
                        {"type", typeName(Pointer.Reference)},
                        {"reference", hexadecimal(Pointer.Reference)}};
  case TracedPointer::Nothing:
    return json::Object{{"to", "nothing"}};
  }
  llvm_unreachable("every pointer has a form");
}

static json::Array slotsJson(ArrayRef<TracedSlot> Slots) {
  json::Array Result;
  for (const TracedSlot &Slot : Slots) {
    json::Object Entry{{"loaded", Slot.Loaded}};
    if (Slot.Loaded) {
      Entry["type"] = Slot.IsLeaf ? "leaf" : "interior";
      Entry["source"] = hexadecimal(Slot.Source);
      Entry["depth"] = Slot.Depth;
      Entry["parent"] = Slot.Parent == CacheMirror::None
                            ? json::Value(nullptr)
                            : json::Value(Slot.Parent);
      json::Array Pointers;
      for (const TracedPointer &Pointer : Slot.Pointers)
        Pointers.push_back(pointerJson(Pointer));
      Entry["pointers"] = std::move(Pointers);
    }
    Result.push_back(std::move(Entry));
  }
  return Result;
}

void writeJson(const CacheTrace &Trace, raw_ostream &OS) {
  const DeletionRecord &Record = *Trace.Record;
  const CacheShape &Shape = Record.Before.shape();
  json::Object Root{
      {"format_version", 1},
      {"thread", Trace.Which.Thread},
      {"deletion", Trace.Which.Deletion},
      {"ray", Record.Ray},
      {"slots", Shape.Slots},
      {"slot_bytes", Shape.SlotBytes},
      {"slot_triangles", Shape.SlotTriangles},
      {"path", json::Array(Record.Path)},
      {"freed", json::Array(Record.Freed)},
      {"before", slotsJson(Trace.Before)},
      {"after", slotsJson(Trace.After)},
  };
  OS << formatv("{0:2}\n", json::Value(std::move(Root)));
}

} // namespace tp
