// -mfma: a feature of the function, so that the link sees it too, and a macro.
//
// RUN: tpcc -O1 -S -emit-llvm -mfma %s -o - | FileCheck --check-prefix=FMA %s
// RUN: tpcc -O1 -S -emit-llvm %s -o - | FileCheck --check-prefix=NOFMA %s
// RUN: tpcc -O1 -S -emit-llvm -mfma -mno-fma %s -o - | FileCheck --check-prefix=NOFMA %s
// RUN: tpcc -O1 -S -emit-llvm -mno-fma -mfma -mno-trig %s -o - | FileCheck --check-prefix=NOTRIG %s
// RUN: tpcc -O1 -S -mfma %s -o - | FileCheck --check-prefix=CODE %s
//
// The link compiles what was compiled with -mfma for a chip that has it.
// RUN: tpcc -O2 -c -emit-llvm -mfma %s -o %t.bc
// RUN: tpcc -O2 -nostdlib -Wl,-e,fused %t.bc -o %t.elf
// RUN: tp-objdump -d %t.elf | FileCheck --check-prefix=CODE %s
// RUN: tpcc -O2 -nostdlib -Wl,-e,fused -mfma %s -o %t.elf
// RUN: tp-objdump -d %t.elf | FileCheck --check-prefix=CODE %s
// RUN: tpcc -O2 -nostdlib -Wl,-e,sum -DBOTH=0 %s -o %t.elf
// RUN: tp-objdump -d %t.elf | FileCheck --check-prefix=NOCODE %s

// FMA: call {{.*}}i32 @withFma
// NOFMA: call {{.*}}i32 @withoutFma
// FMA: "target-features"="+fma,+trig"
// NOTRIG: "target-features"="+fma,-trig"
// NOFMA-NOT: +fma
// CODE: madd_s
// NOCODE-NOT: madd_s
extern "C" {
#ifndef BOTH
int withFma();
int withoutFma();
int which() {
#ifdef __TP_FMA__
  return withFma();
#else
  return withoutFma();
#endif
}
float fused(float A, float B, float C) { return __builtin_fmaf(A, B, C); }
#endif
float sum(float A, float B, float C) { return A * B + C; }
}
