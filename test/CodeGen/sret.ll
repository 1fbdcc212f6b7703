; RUN: %llc_tp -O2 -verify-machineinstrs < %s | FileCheck %s
; RUN: %llc_tp -O0 -verify-machineinstrs -filetype=obj -o %t.o < %s

%struct.three = type { i32, i32, i32 }
declare void @make(ptr sret(%struct.three) align 4, i32)
define i32 @use() {
; CHECK-LABEL: use:
; CHECK: addi r29, r29, -16
; CHECK-NEXT: sw r31, 12(r29)
; CHECK-NEXT: move r4, r29
; CHECK-NEXT: addi r5, r0, 5
; CHECK-NEXT: jal make
; CHECK-NEXT: lw r4, 8(r29)
; CHECK-NEXT: lw r31, 12(r29)
; CHECK-NEXT: addi r29, r29, 16
; CHECK-NEXT: ret
  %s = alloca %struct.three, align 4
  call void @make(ptr sret(%struct.three) align 4 %s, i32 5)
  %f = getelementptr %struct.three, ptr %s, i32 0, i32 2
  %v = load i32, ptr %f
  ret i32 %v
}
define void @define_make(ptr sret(%struct.three) align 4 %s, i32 %x) {
; CHECK-LABEL: define_make:
; CHECK: sw r5, 0(r4)
; CHECK-NEXT: ret
  store i32 %x, ptr %s
  ret void
}
define { i32, i32, float, float } @four() {
; CHECK-LABEL: four:
; CHECK: lui r12, 16256
; CHECK-NEXT: mtc1 f5, r12
; CHECK-NEXT: addi r4, r0, 1
; CHECK-NEXT: addi r5, r0, 2
; CHECK-NEXT: mtc1 f4, r0
; CHECK-NEXT: ret
  ret { i32, i32, float, float } { i32 1, i32 2, float 0.0, float 1.0 }
}
define { i32, i32, i32 } @three(i32 %x) {
; CHECK-LABEL: three:
; CHECK: addi r12, r0, 2
; CHECK-NEXT: sw r12, 4(r4)
; CHECK-NEXT: addi r12, r0, 1
; CHECK-NEXT: sw r5, 8(r4)
; CHECK-NEXT: sw r12, 0(r4)
; CHECK-NEXT: ret
  %r = insertvalue { i32, i32, i32 } { i32 1, i32 2, i32 undef }, i32 %x, 2
  ret { i32, i32, i32 } %r
}
define i32 @call_three() {
; CHECK-LABEL: call_three:
; CHECK: addi r29, r29, -16
; CHECK-NEXT: sw r31, 12(r29)
; CHECK-NEXT: move r4, r29
; CHECK-NEXT: addi r5, r0, 9
; CHECK-NEXT: jal three
; CHECK-NEXT: lw r4, 8(r29)
; CHECK-NEXT: lw r31, 12(r29)
; CHECK-NEXT: addi r29, r29, 16
; CHECK-NEXT: ret
  %r = call { i32, i32, i32 } @three(i32 9)
  %v = extractvalue { i32, i32, i32 } %r, 2
  ret i32 %v
}
