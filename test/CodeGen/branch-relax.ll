; RUN: %llc_tp -O2 -verify-machineinstrs < %s | FileCheck %s
; RUN: %llc_tp -O0 -verify-machineinstrs -filetype=obj -o %t.o < %s

; A branch reaches 128 KiB; one beyond is turned round over a jump.
define void @far(i32 %a, i32 %b) {
; CHECK-LABEL: far:
; CHECK: blt r4, r5, .LBB0_1
; CHECK-NEXT: j .LBB0_2
; CHECK-NEXT: .LBB0_1:
; CHECK: .zero 140000
; CHECK: ret
; CHECK-NEXT: .LBB0_2:
; CHECK: nop
; CHECK: ret
  %c = icmp slt i32 %a, %b
  br i1 %c, label %yes, label %no
yes:
  call void asm sideeffect ".space 140000", ""()
  ret void
no:
  call void asm sideeffect "nop", ""()
  ret void
}
define void @near(i32 %a, i32 %b) {
; CHECK-LABEL: near:
; CHECK: bge r4, r5, .LBB1_2
; CHECK: .zero 120000
; CHECK: ret
; CHECK-NEXT: .LBB1_2:
; CHECK: nop
; CHECK: ret
  %c = icmp slt i32 %a, %b
  br i1 %c, label %yes, label %no
yes:
  call void asm sideeffect ".space 120000", ""()
  ret void
no:
  call void asm sideeffect "nop", ""()
  ret void
}
