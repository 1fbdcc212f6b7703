; RUN: %llc_tp -O2 -verify-machineinstrs < %s | FileCheck %s
; RUN: %llc_tp -O0 -verify-machineinstrs -filetype=obj -o %t.o < %s

%struct.small = type { i32, i32, i8 }
%struct.large = type { [64 x i32] }
declare void @take_small(ptr byval(%struct.small) align 4, i32)
declare void @take_large(ptr byval(%struct.large) align 4, ptr byval(%struct.small) align 4)

define void @pass_small(ptr %p) {
; CHECK-LABEL: pass_small:
; CHECK: addi r29, r29, -24
; CHECK-NEXT: sw r31, 20(r29)
; CHECK-NEXT: sw r16, 16(r29)
; CHECK-NEXT: move r16, r4
; CHECK-NEXT: lw r14, 8(r16)
; CHECK-NEXT: lw r13, 4(r16)
; CHECK-NEXT: lw r12, 0(r16)
; CHECK-NEXT: addi r4, r29, 4
; CHECK-NEXT: addi r5, r0, 7
; CHECK-NEXT: sw r14, 12(r29)
; CHECK-NEXT: sw r13, 8(r29)
; CHECK-NEXT: sw r12, 4(r29)
; CHECK-NEXT: jal take_small
; CHECK-NEXT: lw r14, 8(r16)
; CHECK-NEXT: lw r13, 4(r16)
; CHECK-NEXT: lw r12, 0(r16)
; CHECK-NEXT: addi r4, r29, 4
; CHECK-NEXT: addi r5, r0, 8
; CHECK-NEXT: sw r14, 12(r29)
; CHECK-NEXT: sw r13, 8(r29)
; CHECK-NEXT: sw r12, 4(r29)
; CHECK-NEXT: jal take_small
; CHECK-NEXT: lw r16, 16(r29)
; CHECK-NEXT: lw r31, 20(r29)
; CHECK-NEXT: addi r29, r29, 24
; CHECK-NEXT: ret
  call void @take_small(ptr byval(%struct.small) align 4 %p, i32 7)
  call void @take_small(ptr byval(%struct.small) align 4 %p, i32 8)
  ret void
}
define void @pass_large(ptr %p, ptr %q) {
; CHECK-LABEL: pass_large:
; CHECK: addi r29, r29, -280
; CHECK-NEXT: sw r31, 276(r29)
; CHECK-NEXT: sw r16, 272(r29)
; CHECK-NEXT: move r16, r5
; CHECK-NEXT: move r5, r4
; CHECK-NEXT: addi r4, r29, 16
; CHECK-NEXT: addi r6, r0, 256
; CHECK-NEXT: jal memcpy
; CHECK-NEXT: lw r14, 0(r16)
; CHECK-NEXT: lw r13, 4(r16)
; CHECK-NEXT: lw r12, 8(r16)
; CHECK-NEXT: addi r4, r29, 16
; CHECK-NEXT: addi r5, r29, 4
; CHECK-NEXT: sw r14, 4(r29)
; CHECK-NEXT: sw r13, 8(r29)
; CHECK-NEXT: sw r12, 12(r29)
; CHECK-NEXT: jal take_large
; CHECK-NEXT: lw r16, 272(r29)
; CHECK-NEXT: lw r31, 276(r29)
; CHECK-NEXT: addi r29, r29, 280
; CHECK-NEXT: ret
  call void @take_large(ptr byval(%struct.large) align 4 %p, ptr byval(%struct.small) align 4 %q)
  ret void
}
define i32 @receive(ptr byval(%struct.small) align 4 %s) {
; CHECK-LABEL: receive:
; CHECK: move r12, r4
; CHECK-NEXT: lw r4, 4(r12)
; CHECK-NEXT: addi r13, r0, 1
; CHECK-NEXT: sw r13, 4(r12)
; CHECK-NEXT: ret
  %f = getelementptr %struct.small, ptr %s, i32 0, i32 1
  %v = load i32, ptr %f
  store i32 1, ptr %f
  ret i32 %v
}
define void @forward(ptr byval(%struct.small) align 4 %s) {
; CHECK-LABEL: forward:
; CHECK: addi r29, r29, -16
; CHECK-NEXT: sw r31, 12(r29)
; CHECK-NEXT: lw r14, 8(r4)
; CHECK-NEXT: lw r13, 4(r4)
; CHECK-NEXT: lw r12, 0(r4)
; CHECK-NEXT: move r4, r29
; CHECK-NEXT: addi r5, r0, 7
; CHECK-NEXT: sw r14, 8(r29)
; CHECK-NEXT: sw r13, 4(r29)
; CHECK-NEXT: sw r12, 0(r29)
; CHECK-NEXT: jal take_small
; CHECK-NEXT: lw r31, 12(r29)
; CHECK-NEXT: addi r29, r29, 16
; CHECK-NEXT: ret
  tail call void @take_small(ptr byval(%struct.small) align 4 %s, i32 7)
  ret void
}
