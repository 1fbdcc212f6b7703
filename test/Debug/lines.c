// Where debuggers stop: behind the prologue, at each statement, and before the
// epilogue; saving and reloading registers belongs to no statement.
//
// RUN: tpcc -O2 -g -fno-lto -nostdlib -Wl,--no-gc-sections,-e,function %s -o %t
// RUN: llvm-dwarfdump --debug-line %t | FileCheck %s
// RUN: tp-objdump -d %t | FileCheck %s --check-prefix=CODE

// CODE: <function>:
// CODE: addi r29, r29, -8
// CODE: sw r31
// CODE: sw r16
// CODE: 10018:
// CHECK: 0x0000000000010004 [[#LINE:]]
// CHECK-SAME: is_stmt{{$}}
// CHECK-NEXT: 0x0000000000010018 [[#LINE + 1]] {{.*}} is_stmt prologue_end
// CHECK-NOT: {{0x0000000000[0-9a-f]+}} 0
// CHECK: [[#LINE + 2]] {{.*}} epilogue_begin
// CHECK: end_sequence
__attribute__((noinline)) void callee(int Value) {
  __asm__ volatile("" ::"r"(Value));
}

int function(int Argument) {
  callee(Argument * 3);
  return Argument + 2;
}
