//===- SceneFacts.cpp - What a scene and its tree consist of --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The program tp-scene.
//
//===----------------------------------------------------------------------===//

#include "kernels/common/SceneFlattener.h"
#include "kernels/common/SceneLayout.h"
#include "scenes/loader/SceneLoader.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <sys/resource.h>
#include <vector>

namespace tp {

namespace {

struct TreeFacts {
  /// Inner nodes on the longest way from the root to a leaf.
  uint32_t Depth = 0;
  uint32_t Children = 0;
  uint32_t Leaves = 0;
  /// [number of triangles]: leaves.
  std::array<uint32_t, kMaxLeafTriangles + 1> LeavesBySize = {};
};

class Stopwatch {
public:
  /// Seconds since the last call, at first since the construction.
  double lap() {
    const auto Now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> Elapsed = Now - Last;
    Last = Now;
    return Elapsed.count();
  }

private:
  std::chrono::steady_clock::time_point Last = std::chrono::steady_clock::now();
};

} // namespace

static bool isEmptySlot(const WideBvhNode &Node, uint32_t Child) {
  return Node.Bounds[0][0][Child] > Node.Bounds[0][1][Child];
}

static TreeFacts measureTree(const SceneView &View) {
  struct Subtree {
    BvhReference Root;
    uint32_t NodesAbove;
  };
  TreeFacts Facts;
  std::vector<Subtree> Pending = {{View.Header->Root, 0}};
  while (!Pending.empty()) {
    const auto [Reference, NodesAbove] = Pending.back();
    Pending.pop_back();
    if (isLeaf(Reference)) {
      Facts.Depth = std::max(Facts.Depth, NodesAbove);
      ++Facts.Leaves;
      ++Facts.LeavesBySize[leafCount(Reference)];
      continue;
    }
    WideBvhNode Node;
    std::memcpy(&Node, View.Nodes + Reference, sizeof(Node));
    for (uint32_t Child = 0; Child != kWideBvhWidth; ++Child) {
      if (isEmptySlot(Node, Child))
        continue;
      ++Facts.Children;
      Pending.push_back({Node.Child[Child], NodesAbove + 1});
    }
  }
  return Facts;
}

static double share(double Part, double Whole) {
  return Whole == 0 ? 0 : Part / Whole;
}

static void printFacts(const SceneView &View) {
  const SceneHeader &Header = *View.Header;
  const TreeFacts Facts = measureTree(View);
  std::printf("triangles: %u, of which %u emit light\n", Header.TriangleCount,
              Header.LightCount);
  std::printf("materials: %u\n", Header.MaterialCount);
  std::printf("nodes:     %u with %.2f children on average, at most %u on a "
              "path\n",
              Header.NodeCount, share(Facts.Children, Header.NodeCount),
              Facts.Depth);
  std::printf("leaves:    %u with %.2f triangles on average\n", Facts.Leaves,
              share(Header.TriangleCount, Facts.Leaves));
  std::printf("  by size:");
  for (uint32_t Size = 1; Size <= kMaxLeafTriangles; ++Size)
    if (Facts.LeavesBySize[Size] != 0)
      std::printf(" %u: %.2f%%", Size,
                  100 * share(Facts.LeavesBySize[Size], Facts.Leaves));
  std::printf("\nbytes:     %u\n", Header.ByteCount);
}

static int describeScene(const char *Path) {
  Stopwatch Watch;
  const ErrorOr<Scene> Source = loadScene(Path);
  if (!Source) {
    std::fprintf(stderr, "tp-scene: error: %s\n", Source.message().c_str());
    return 1;
  }
  for (const std::string &Warning : Source->Warnings)
    std::fprintf(stderr, "tp-scene: warning: %s: %s\n", Path, Warning.c_str());
  const double LoadSeconds = Watch.lap();
  const std::vector<uint8_t> Block = flattenScene(*Source);
  const double TreeSeconds = Watch.lap();
  printFacts(SceneView(Block.data()));
  rusage Usage{};
  getrusage(RUSAGE_SELF, &Usage);
  std::printf("time:      %.2f s to read the file, %.2f s to build the tree, "
              "%.0f MiB of memory\n",
              LoadSeconds, TreeSeconds, double(Usage.ru_maxrss) / 1024);
  return 0;
}

} // namespace tp

int main(int ArgumentCount, char **Arguments) {
  const bool Help = ArgumentCount == 2 && !std::strcmp(Arguments[1], "--help");
  if (ArgumentCount != 2 || Help) {
    std::fputs("USAGE: tp-scene FILE\n\nPrints what a glTF or GLB file and its "
               "tree consist of.\n",
               Help ? stdout : stderr);
    return Help ? 0 : 1;
  }
  return tp::describeScene(Arguments[1]);
}
