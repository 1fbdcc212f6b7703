; RUN: %llc_tp -O2 -verify-machineinstrs -enable-machine-outliner < %s | FileCheck %s
; RUN: %llc_tp -O2 < %s | FileCheck %s --check-prefix=OFF

; OFF-NOT: OUTLINED

@sink = global [8 x i32] zeroinitializer

declare void @other()

; The stores occur twice, where the return address is in the frame.
define void @first() {
; CHECK-LABEL: first:
; CHECK: sw r31, [[#]](r29)
; CHECK: jal other
; CHECK-NEXT: jal OUTLINED_FUNCTION_0
; CHECK-NEXT: jal other
; CHECK: ret
  call void @other()
  store volatile i32 11, ptr @sink
  store volatile i32 22, ptr getelementptr (i32, ptr @sink, i32 1)
  store volatile i32 33, ptr getelementptr (i32, ptr @sink, i32 2)
  store volatile i32 44, ptr getelementptr (i32, ptr @sink, i32 3)
  call void @other()
  ret void
}

define void @second() {
; CHECK-LABEL: second:
; CHECK: jal other
; CHECK-NEXT: jal OUTLINED_FUNCTION_0
; CHECK-NEXT: jal other
; CHECK: ret
  call void @other()
  store volatile i32 11, ptr @sink
  store volatile i32 22, ptr getelementptr (i32, ptr @sink, i32 1)
  store volatile i32 33, ptr getelementptr (i32, ptr @sink, i32 2)
  store volatile i32 44, ptr getelementptr (i32, ptr @sink, i32 3)
  call void @other()
  ret void
}

; Here the call would destroy it.
define void @leaf() {
; CHECK-LABEL: leaf:
; CHECK-NOT: jal
; CHECK: ret
  store volatile i32 11, ptr @sink
  store volatile i32 22, ptr getelementptr (i32, ptr @sink, i32 1)
  store volatile i32 33, ptr getelementptr (i32, ptr @sink, i32 2)
  store volatile i32 44, ptr getelementptr (i32, ptr @sink, i32 3)
  ret void
}

; CHECK-LABEL: OUTLINED_FUNCTION_0:
; CHECK: addi [[VALUE:r[0-9]+]], r0, 11
; CHECK: sw [[VALUE]], %lo(sink)
; CHECK: ret
