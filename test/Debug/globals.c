// Global, static and thread_local objects by their addresses, which are fixed.
//
// RUN: tpcc -O0 -g -fno-lto -nostdlib -Wl,--no-gc-sections,-e,use %s -o %t
// RUN: llvm-dwarfdump --debug-info %t | FileCheck %s
// RUN: llvm-dwarfdump --debug-addr %t | FileCheck %s --check-prefix=ADDRESSES
// RUN: llvm-readelf -s %t | FileCheck %s --check-prefix=SYMBOLS
// RUN: tpcc -O0 -g -gdwarf-4 -fno-lto -nostdlib -Wl,--no-gc-sections,-e,use %s -o %t.4
// RUN: llvm-dwarfdump --name=External %t.4 | FileCheck %s --check-prefix=DWARF4

// CHECK: DW_AT_name ("External")
// CHECK: DW_AT_location (DW_OP_addrx 0x0)
// CHECK: DW_AT_name ("PerThread")
// CHECK: DW_AT_location (DW_OP_const4u 0x[[#%x,THREAD:]], DW_OP_GNU_push_tls_address)
// CHECK: DW_AT_name ("InFunction")
// CHECK: DW_AT_location (DW_OP_addrx
// ADDRESSES: Addrs: [
// ADDRESSES-NEXT: 0x00011
// SYMBOLS-DAG: 00011{{.*}} External
// SYMBOLS-DAG: ffffff{{.*}} PerThread
// DWARF4: DW_AT_location (DW_OP_addr 0x11{{[0-9a-f]+}})
int External = 3;
_Thread_local int PerThread = 4;
int use(void) {
  static int InFunction = 5;
  return External + PerThread + ++InFunction;
}
