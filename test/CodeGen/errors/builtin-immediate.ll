; RUN: not %llc_tp -O2 -o /dev/null < %s 2>&1 | FileCheck %s
; CHECK: error: {{.*}}the first argument of 'tp_prof' has to be a constant from 0 to 65535

declare void @tp_prof(i32)
define void @marker(i32 %i) {
  call void @tp_prof(i32 %i)
  ret void
}
