// A variable that is built where the caller wants the result.
//
// RUN: tpcc -O2 -g -fno-lto -nostdlib -Wl,--no-gc-sections,-e,build %s -o %t
// RUN: llvm-dwarfdump --name=Result %t | FileCheck %s

// CHECK: DW_OP_breg4 +0
// CHECK: DW_AT_name ("Result")
struct Block {
  int Values[8];
};
extern "C" Block build(int Value) {
  Block Result;
  for (int &Element : Result.Values)
    Element = Value;
  asm volatile("" ::"r"(&Result) : "memory");
  Result.Values[2] = 5;
  return Result;
}
