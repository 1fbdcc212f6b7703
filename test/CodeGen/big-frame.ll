; RUN: %llc_tp -O2 -verify-machineinstrs < %s | FileCheck %s
; RUN: %llc_tp -O0 -verify-machineinstrs -filetype=obj -o %t.o < %s

declare void @use(ptr)
define void @just_fits() {
; CHECK-LABEL: just_fits:
; CHECK: addi r29, r29, -32008
; CHECK-NEXT: sw r31, 32004(r29)
; CHECK-NEXT: addi r4, r29, 4
; CHECK-NEXT: jal use
; CHECK-NEXT: lw r31, 32004(r29)
; CHECK-NEXT: addi r29, r29, 32008
; CHECK-NEXT: ret
  %a = alloca [32000 x i8]
  call void @use(ptr %a)
  ret void
}
define i32 @too_big(i32 %i) {
; CHECK-LABEL: too_big:
; CHECK: lui r1, 65534
; CHECK-NEXT: ori r1, r1, 31056
; CHECK-NEXT: add r29, r29, r1
; CHECK-NEXT: lui r1, 2
; CHECK-NEXT: add r1, r1, r29
; CHECK-NEXT: sw r31, -31060(r1)
; CHECK-NEXT: lui r1, 2
; CHECK-NEXT: add r1, r1, r29
; CHECK-NEXT: sw r16, -31064(r1)
; CHECK-NEXT: lui r1, 2
; CHECK-NEXT: add r1, r1, r29
; CHECK-NEXT: sw r17, -31068(r1)
; CHECK-NEXT: move r16, r4
; CHECK-NEXT: addi r4, r29, 4
; CHECK-NEXT: addi r17, r29, 4
; CHECK-NEXT: jal use
; CHECK-NEXT: move r4, r29
; CHECK-NEXT: jal use
; CHECK-NEXT: lui r1, 2
; CHECK-NEXT: add r1, r1, r29
; CHECK-NEXT: lbux r13, r16(r17)
; CHECK-NEXT: lw r17, -31068(r1)
; CHECK-NEXT: lui r1, 2
; CHECK-NEXT: add r1, r1, r29
; CHECK-NEXT: lw r16, -31064(r1)
; CHECK-NEXT: lui r1, 2
; CHECK-NEXT: add r1, r1, r29
; CHECK-NEXT: lw r31, -31060(r1)
; CHECK-NEXT: lw r12, 0(r29)
; CHECK-NEXT: add r4, r12, r13
; CHECK-NEXT: lui r1, 1
; CHECK-NEXT: ori r1, r1, 34480
; CHECK-NEXT: add r29, r29, r1
; CHECK-NEXT: ret
  %a = alloca [100000 x i8]
  %b = alloca i32
  call void @use(ptr %a)
  call void @use(ptr %b)
  %v = load i32, ptr %b
  %p = getelementptr [100000 x i8], ptr %a, i32 0, i32 %i
  %w = load i8, ptr %p
  %x = zext i8 %w to i32
  %y = add i32 %v, %x
  ret i32 %y
}
