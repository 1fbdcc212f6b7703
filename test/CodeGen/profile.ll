; Profile instructions keep their order, their branch and their loop, and no
; memory access waits for them.
; RUN: %llc_tp -O2 -verify-machineinstrs < %s | FileCheck %s
; RUN: %llc_tp -O0 -verify-machineinstrs -filetype=obj -o %t.o < %s

declare void @tp_prof(i32)
declare void @tp_profv(i32, i32)

; Both loads start before the addition: the message between them is no barrier.
define float @loads(ptr %p, ptr %q, float %x) {
; CHECK-LABEL: loads:
; CHECK: lwc1 f12, 0(r4)
; CHECK-NEXT: lwc1 f13, 0(r5)
; CHECK-NEXT: profv 256, r4
; CHECK-NEXT: add_s f12, f12, f4
; CHECK-NEXT: add_s f4, f12, f13
; CHECK-NEXT: ret
  %a = load float, ptr %p
  %b = fadd float %a, %x
  %i = ptrtoint ptr %p to i32
  call void @tp_profv(i32 256, i32 %i)
  %c = load float, ptr %q
  %d = fadd float %b, %c
  ret float %d
}
; A message takes the value in flight and does not hold up what follows.
define i32 @between(ptr %p) {
; CHECK-LABEL: between:
; CHECK: lw r13, 0(r4)
; CHECK-NEXT: lw r12, 4(r4)
; CHECK-NEXT: profv 256, r13
; CHECK-NEXT: profv 257, r12
; CHECK-NEXT: add r4, r13, r12
; CHECK-NEXT: ret
  %a = load i32, ptr %p
  call void @tp_profv(i32 256, i32 %a)
  %q = getelementptr i32, ptr %p, i32 1
  %b = load i32, ptr %q
  call void @tp_profv(i32 257, i32 %b)
  %sum = add i32 %a, %b
  ret i32 %sum
}

; Equal messages are as many as the program sends.
define void @order(i32 %v) {
; CHECK-LABEL: order:
; CHECK: profv 65535, r4
; CHECK-NEXT: prof 7
; CHECK-NEXT: profv 65535, r4
; CHECK-NEXT: profv 1, r0
; CHECK-NEXT: ret
  call void @tp_profv(i32 65535, i32 %v)
  call void @tp_prof(i32 7)
  call void @tp_profv(i32 65535, i32 %v)
  call void @tp_profv(i32 1, i32 0)
  ret void
}

; Neither hoisted out of the loop nor sunk behind it.
define void @loop(i32 %n, i32 %v) {
; CHECK-LABEL: loop:
; CHECK: move r12, r0
; CHECK-NEXT: .LBB3_1:
; CHECK: profv 256, r5
; CHECK: sleep r12
; CHECK: addi r12, r12, 1
; CHECK-NEXT: bne r4, r12, .LBB3_1
; CHECK: ret
entry:
  br label %body
body:
  %i = phi i32 [0, %entry], [%next, %body]
  call void @tp_profv(i32 256, i32 %v)
  call void asm sideeffect "sleep $0", "r"(i32 %i)
  %next = add i32 %i, 1
  %more = icmp ne i32 %next, %n
  br i1 %more, label %body, label %end
end:
  ret void
}

define i32 @branch(i32 %c, i32 %v) {
; CHECK-LABEL: branch:
; CHECK: beq r4, r0, .LBB4_2
; CHECK: profv 256, r5
; CHECK-NEXT: .LBB4_2:
; CHECK-NEXT: add r4, r4, r5
; CHECK-NEXT: ret
  %taken = icmp ne i32 %c, 0
  br i1 %taken, label %then, label %end
then:
  call void @tp_profv(i32 256, i32 %v)
  br label %end
end:
  %sum = add i32 %c, %v
  ret i32 %sum
}
