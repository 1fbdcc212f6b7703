// Accesses behind what the launch brings are found, and undefined values that
// reach the picture.
//
// DEFINE: %{run} = tpsim --chip 1x1 --quiet --size 8x4 --scene \
// DEFINE:   %scenes/instances/instances.glb
//
// RUN: tpcc -O2 -g -I%source_dir %s -o %t.elf
// RUN: not %{run} --check=memory %t.elf -- nodes 2>&1 \
// RUN:   | FileCheck %s --check-prefix=NODES
// RUN: not %{run} --check=memory %t.elf -- lights 2>&1 \
// RUN:   | FileCheck %s --check-prefix=LIGHTS
// RUN: not %{run} --check=memory %t.elf -- framebuffer 2>&1 \
// RUN:   | FileCheck %s --check-prefix=FRAMEBUFFER
// RUN: not %{run} --check=memory --bvh kernel %t.elf -- order 2>&1 \
// RUN:   | FileCheck %s --check-prefix=ORDER
// RUN: not %{run} --check=init %t.elf -- picture 2>&1 \
// RUN:   | FileCheck %s --check-prefix=PICTURE
// RUN: %{run} --check=all %t.elf 2>&1 | count 0

#include "kernels/common/SceneLayout.h"
#include "tp/launch.h"
#include "tp/memory.h"
#include <stdlib.h>
#include <string.h>

using namespace tp;

static volatile uint32_t Sink;

/// Reads each word of the records.
template <class T>
[[gnu::noinline]] static void readAll(const T *Records, uint32_t Count) {
  auto *Words = reinterpret_cast<const volatile uint32_t *>(Records);
  for (uint32_t I = 0; I != Count * (sizeof(T) / sizeof(uint32_t)); ++I)
    Sink = Words[I];
}

int main(int ArgumentCount, char **Arguments) {
  const char *Fault = ArgumentCount > 1 ? Arguments[1] : "none";
  auto more = [&](const char *Name) { return !strcmp(Fault, Name); };
  const LaunchBlock Launch = launchBlock();
  const SceneView Scene(devicePointer<const SceneHeader>(Launch.Scene));
  const SceneHeader &Header = *Scene.Header;
  // NODES: error: launch-out-of-bounds: load of 4 bytes at 0x
  // NODES-NEXT: right behind the scene's nodes of {{[0-9]+}} bytes
  // NODES: in main at {{.*}}launch.cpp:[[@LINE+1]]:
  readAll(reinterpret_cast<const WideBvhNode *>(Scene.Nodes),
          Header.NodeCount + more("nodes"));
  readAll(Scene.Triangles, Header.TriangleCount);
  readAll(Scene.Materials, Header.MaterialCount);
  // LIGHTS: error: launch-out-of-bounds: load of 4 bytes
  // LIGHTS-NEXT: right behind the scene's lights of {{[0-9]+}} bytes
  readAll(Scene.Lights, Header.LightCount + more("lights"));
  readAll(Scene.LightChoices, Header.LightCount);
  if (Header.WorkspaceOffset != 0) {
    const auto *Block = reinterpret_cast<const char *>(Scene.Header);
    const auto *Space = reinterpret_cast<const BvhWorkspace *>(
        Block + Header.WorkspaceOffset);
    readAll(reinterpret_cast<const TriangleRecord *>(Block +
                                                     Space->SourcesOffset),
            Header.TriangleCount);
    // ORDER: error: launch-out-of-bounds: load of 4 bytes
    // ORDER-NEXT: right behind the triangles' order of 68 bytes
    readAll(reinterpret_cast<const uint32_t *>(Block + Space->OrderOffset),
            Header.TriangleCount + more("order"));
  }
  auto *Pixels = devicePointer<uint32_t>(Launch.Framebuffer);
  // FRAMEBUFFER: error: launch-out-of-bounds: store of 4 bytes
  // FRAMEBUFFER-NEXT: right behind the framebuffer of 128 bytes
  // FRAMEBUFFER: in main at {{.*}}launch.cpp:[[@LINE+3]]:
  const uint32_t Count = Launch.Width * Launch.Height + more("framebuffer");
  for (uint32_t I = 0; I != Count; ++I)
    static_cast<volatile uint32_t *>(Pixels)[I] = I;
  if (more("picture")) {
    // PICTURE: error: undefined-output: byte 20 of the framebuffer is undefined at 0x
    // PICTURE-NEXT: memory that nobody has written, 4 bytes into a heap block of 12 bytes
    // PICTURE: allocated by thread 0
    // PICTURE: in main at {{.*}}launch.cpp:[[@LINE+2]]:
    // PICTURE: checks: 1 fault
    auto *Unwritten = static_cast<volatile uint32_t *>(malloc(12));
    Pixels[5] = Unwritten[1];
  }
  return 0;
}
