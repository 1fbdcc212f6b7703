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
; CHECK-DAG: profv 256, r4
; CHECK-DAG: add_s f0
; CHECK: ret
  %a = load float, ptr %p
  %b = fadd float %a, %x
  %i = ptrtoint ptr %p to i32
  call void @tp_profv(i32 256, i32 %i)
  %c = load float, ptr %q
  %d = fadd float %b, %c
  ret float %d
}
; A message takes the value in flight and does not hold up what follows.
; CHECK-LABEL: between:
; CHECK: lw [[A:r[0-9]+]], 0(r4)
; CHECK: lw [[B:r[0-9]+]], 4(r4)
; CHECK-DAG: profv 256, [[A]]
; CHECK-DAG: profv 257, [[B]]
; CHECK-DAG: add r2
; CHECK: ret
define i32 @between(ptr %p) {
  %a = load i32, ptr %p
  call void @tp_profv(i32 256, i32 %a)
  %q = getelementptr i32, ptr %p, i32 1
  %b = load i32, ptr %q
  call void @tp_profv(i32 257, i32 %b)
  %sum = add i32 %a, %b
  ret i32 %sum
}

; Equal messages are as many as the program sends.
; CHECK-LABEL: order:
; CHECK: profv 65535, r4
; CHECK-NEXT: prof 7
; CHECK-NEXT: profv 65535, r4
; CHECK-NEXT: profv 1, r0
; CHECK-NEXT: ret
define void @order(i32 %v) {
  call void @tp_profv(i32 65535, i32 %v)
  call void @tp_prof(i32 7)
  call void @tp_profv(i32 65535, i32 %v)
  call void @tp_profv(i32 1, i32 0)
  ret void
}

; Neither hoisted out of the loop nor sunk behind it.
; CHECK-LABEL: loop:
; CHECK: .LBB{{[0-9_]+}}:
; CHECK-NOT: ret
; CHECK: profv 256, r5
; CHECK-NOT: ret
; CHECK: bne
; CHECK-NOT: profv
; CHECK: ret
define void @loop(i32 %n, i32 %v) {
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

; CHECK-LABEL: branch:
; CHECK: beq r4, r0, [[OTHER:.LBB[0-9_]+]]
; CHECK-NOT: .LBB
; CHECK: profv 256, r5
; CHECK: [[OTHER]]:
; CHECK-NOT: profv
; CHECK: ret
define i32 @branch(i32 %c, i32 %v) {
  %taken = icmp ne i32 %c, 0
  br i1 %taken, label %then, label %end
then:
  call void @tp_profv(i32 256, i32 %v)
  br label %end
end:
  %sum = add i32 %c, %v
  ret i32 %sum
}
