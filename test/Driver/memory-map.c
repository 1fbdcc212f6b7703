// Where the linker puts things, and the symbols that say so.
//
// RUN: tpcc -O1 -g -fno-lto %s -o %t.elf -Wl,-Map=%t.map
// RUN: llvm-readelf -hlSs %t.elf | FileCheck %s
// RUN: FileCheck --check-prefix=MAP %s < %t.map
// RUN: tpsim %t.elf --chip 1x1
// RUN: tpcc -O0 %s -o %t.elf && tpsim %t.elf --chip 1x1

// CHECK: Type: EXEC
// CHECK: Machine: 5450
// CHECK: [ 1] .text PROGBITS 00010000 001000
// CHECK: .rodata PROGBITS 0001
// CHECK: .data PROGBITS
// CHECK: .tdata PROGBITS ffff{{[0-9a-f]+}} {{.*}} WAT
// CHECK: .bss NOBITS
// CHECK: .tbss NOBITS ffff{{[0-9a-f]+}} {{.*}} WAT
// CHECK: LOAD 0x001000 0x00010000 0x00010000 {{.*}} R E
// CHECK: LOAD {{.*}} RW
// CHECK: TLS {{.*}} 0xffff
// CHECK-DAG: fffffff0 0 NOTYPE GLOBAL DEFAULT ABS __tp_tls_end
// CHECK-DAG: __tp_tls_begin
// CHECK-DAG: __tp_stack_top
// CHECK-DAG: __tp_tdata_image
// CHECK-DAG: __tp_tdata_size
// CHECK-DAG: __tp_tbss_size
// CHECK-DAG: __tp_image_end
// CHECK-DAG: FUNC GLOBAL DEFAULT 1 _start
// CHECK-DAG: OBJECT {{.*}} Initialized

// MAP: address size name
// MAP: 00010000 {{.*}} .text
// MAP: main
// MAP: .tbss
// MAP: Zeroed

#include <stdint.h>

#define ADDRESS(Symbol) ((uint32_t)(uintptr_t)&Symbol)
extern char __tp_tls_begin, __tp_tls_end, __tp_stack_top, __tp_tdata_image,
    __tp_tdata_size, __tp_tbss_size, __tp_image_end, _end, __bss_start;

_Thread_local int Initialized = 5;
_Thread_local _Alignas(64) char Aligned[3] = "ab";
_Thread_local int Zeroed[10];
int Data = 3;
const int ReadOnly = 4;
int Bss[100];

// A section with a C name has a beginning and an end.
__attribute__((section("registry"), used)) static int First = 1;
__attribute__((section("registry"), used)) static int Second = 2;
extern int __start_registry[], __stop_registry[];

int main(void) {
  volatile int Local;
  if (ADDRESS(Data) < 0x10000 || ADDRESS(ReadOnly) >= ADDRESS(Data))
    return 1;
  if (ADDRESS(Initialized) < ADDRESS(__tp_tls_begin) ||
      ADDRESS(Zeroed) + sizeof Zeroed > 0xFFFFFFF0)
    return 2;
  if (ADDRESS(Aligned) % 64 || Aligned[1] != 'b' || Initialized != 5)
    return 3;
  if (ADDRESS(__tp_tdata_size) + ADDRESS(__tp_tbss_size) >
      ADDRESS(__tp_tls_end) - ADDRESS(__tp_tls_begin))
    return 4;
  if (ADDRESS(__tp_stack_top) > ADDRESS(__tp_tls_begin) ||
      ADDRESS(__tp_stack_top) % 16 || ADDRESS(Local) >= ADDRESS(__tp_stack_top))
    return 5;
  // Different names have different addresses, the compiler thinks.
  volatile uint32_t End = ADDRESS(_end);
  if (ADDRESS(Bss[99]) >= End || End != ADDRESS(__tp_image_end) || Bss[50])
    return 6;
  if (__stop_registry - __start_registry != 2 ||
      __start_registry[0] + __start_registry[1] != 3)
    return 7;
  return 0;
}
