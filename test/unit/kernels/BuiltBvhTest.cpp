//===- BuiltBvhTest.cpp - Reading a kernel's tree back --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/common/BuiltBvh.h"

#include "kernels/bvhbuilder/SceneBvh.h"
#include "kernels/common/SceneLayout.h"
#include "kernels/native/HostMemory.h"
#include "scenes/loader/SceneLoader.h"
#include "tp/memory.h"

#include <gtest/gtest.h>

using namespace tp;

namespace {

/// A launch of the Cornell box whose tree is left to the kernel.
class BuiltBvhTest : public testing::Test {
protected:
  void SetUp() override {
    host::resetMemory();
    const ErrorOr<Scene> Source =
        loadScene(std::string(TP_SCENES_FOLDER) + "/cornell/cornell.gltf");
    ASSERT_TRUE(Source) << Source.message();
    RenderOptions Options;
    Options.Bvh = BvhOrigin::Kernel;
    ErrorOr<LaunchBlock> Ready = setUpLaunch(*Source, Options, 3, Memory);
    ASSERT_TRUE(Ready) << Ready.message();
    Launch = *Ready;
  }
  void build() { ASSERT_EQ(runOnHost(buildKernel, 3, Launch), 0); }
  std::string failure() {
    const ErrorOr<std::string> Checked = checkBuiltBvh(Launch, Memory, "");
    return Checked ? "none: " + *Checked : Checked.message();
  }
  template <typename T> T *at(uint32_t Offset) {
    return devicePointer<T>(Launch.Scene + Offset);
  }
  SceneHeader &header() { return *at<SceneHeader>(0); }
  BvhWorkspace &workspace() {
    return *at<BvhWorkspace>(header().WorkspaceOffset);
  }

  HostMemory Memory;
  LaunchBlock Launch = {};

private:
  static int buildKernel() {
    return buildSceneBvh(devicePointer<void>(launchBlock().Scene)) ? 0 : 1;
  }
};

} // namespace

TEST_F(BuiltBvhTest, KernelBuildsTheTreeOfTheHost) {
  build();
  const ErrorOr<std::string> Checked = checkBuiltBvh(Launch, Memory, "");
  ASSERT_TRUE(Checked) << Checked.message();
  EXPECT_NE(Checked->find("38 triangles"), std::string::npos) << *Checked;

  const ErrorOr<Scene> Source =
      loadScene(std::string(TP_SCENES_FOLDER) + "/cornell/cornell.gltf");
  const std::vector<uint8_t> ByHost = flattenScene(*Source);
  const auto *Expected = reinterpret_cast<const SceneHeader *>(ByHost.data());
  ASSERT_EQ(header().NodeCount, Expected->NodeCount);
  EXPECT_EQ(header().Root, Expected->Root);
  EXPECT_EQ(std::memcmp(at<char>(header().NodesOffset),
                        &ByHost[Expected->NodesOffset],
                        header().NodeCount * sizeof(WideBvhNode)),
            0);
  EXPECT_EQ(std::memcmp(at<char>(header().TrianglesOffset),
                        &ByHost[Expected->TrianglesOffset],
                        38 * sizeof(TriangleRecord)),
            0);
}

TEST_F(BuiltBvhTest, NothingBuiltIsAnError) {
  EXPECT_EQ(failure(),
            "the kernel has built no BVH, which --bvh kernel leaves to it");
}

TEST_F(BuiltBvhTest, BrokenTreesAreErrors) {
  build();
  uint32_t *Order = at<uint32_t>(workspace().OrderOffset);
  auto *Triangles = at<TriangleRecord>(header().TrianglesOffset);
  Order[0] = Order[1];
  EXPECT_EQ(failure(), "the kernel has not put the triangles in the order of "
                       "the BVH that it built");
  Triangles[0] = Triangles[1];
  EXPECT_NE(failure().find("the binary BVH that the kernel built is broken: "),
            std::string::npos)
      << failure();
  EXPECT_NE(failure().find("(1 triangles lost, 1 repeated)"), std::string::npos)
      << failure();
}

TEST_F(BuiltBvhTest, BrokenWideTreesAreErrors) {
  build();
  at<WideBvhNode>(header().NodesOffset)->Child[1] = 4;
  EXPECT_NE(
      failure().find("the wide BVH that the kernel built is broken: "
                     "child 1 of node 0: the reference 0x4 names no node"),
      std::string::npos)
      << failure();
}

TEST_F(BuiltBvhTest, ImpossibleCountsAreErrors) {
  build();
  workspace().BinaryNodeCount = 38;
  EXPECT_EQ(failure(), "the BVH that the kernel built has 38 nodes, more than "
                       "38 triangles can have");
}

TEST_F(BuiltBvhTest, OverwrittenHeadersAreErrors) {
  build();
  header().NodesOffset = header().ByteCount;
  EXPECT_EQ(failure(), "the kernel has overwritten the header of its scene");
}

TEST_F(BuiltBvhTest, UnwritableFilesAreErrors) {
  build();
  const ErrorOr<std::string> Checked =
      checkBuiltBvh(Launch, Memory, "no-such-folder/tree");
  ASSERT_FALSE(Checked);
  EXPECT_EQ(Checked.message(),
            "no-such-folder/tree: No such file or directory");
}
