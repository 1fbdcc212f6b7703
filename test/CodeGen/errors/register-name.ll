; RUN: not %llc_tp -O2 -o /dev/null < %s 2>&1 | FileCheck %s
; CHECK: register 'r12' is not reserved, so it cannot be a global variable

declare i32 @llvm.read_register.i32(metadata)
define i32 @read() {
  %r = call i32 @llvm.read_register.i32(metadata !0)
  ret i32 %r
}
!0 = !{!"r12"}
