; RUN: not %llc_tp -O2 -o /dev/null < %s 2>&1 | FileCheck %s
; CHECK: error: {{.*}}the first argument of 'tp_profv' has to be a constant from 0 to 65535

declare void @tp_profv(i32, i32)
define void @marker(i32 %i) {
  call void @tp_profv(i32 65536, i32 %i)
  ret void
}
