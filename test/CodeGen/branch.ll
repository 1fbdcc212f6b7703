; RUN: %llc_tp -O2 -verify-machineinstrs < %s | FileCheck %s
; RUN: %llc_tp -O0 -verify-machineinstrs -filetype=obj -o %t.o < %s

define void @eq(i32 %a, i32 %b, ptr %p) {
; CHECK-LABEL: eq:
; CHECK: bne r4, r5, .LBB0_2
; CHECK: addi r12, r0, 1
; CHECK-NEXT: sw r12, 0(r6)
; CHECK-NEXT: .LBB0_2:
; CHECK-NEXT: ret
  %r = icmp eq i32 %a, %b
  br i1 %r, label %yes, label %no
yes:
  store i32 1, ptr %p
  ret void
no:
  ret void
}
define void @ne(i32 %a, i32 %b, ptr %p) {
; CHECK-LABEL: ne:
; CHECK: beq r4, r5, .LBB1_2
; CHECK: addi r12, r0, 1
; CHECK-NEXT: sw r12, 0(r6)
; CHECK-NEXT: .LBB1_2:
; CHECK-NEXT: ret
  %r = icmp ne i32 %a, %b
  br i1 %r, label %yes, label %no
yes:
  store i32 1, ptr %p
  ret void
no:
  ret void
}
define void @slt(i32 %a, i32 %b, ptr %p) {
; CHECK-LABEL: slt:
; CHECK: bge r4, r5, .LBB2_2
; CHECK: addi r12, r0, 1
; CHECK-NEXT: sw r12, 0(r6)
; CHECK-NEXT: .LBB2_2:
; CHECK-NEXT: ret
  %r = icmp slt i32 %a, %b
  br i1 %r, label %yes, label %no
yes:
  store i32 1, ptr %p
  ret void
no:
  ret void
}
define void @sge(i32 %a, i32 %b, ptr %p) {
; CHECK-LABEL: sge:
; CHECK: blt r4, r5, .LBB3_2
; CHECK: addi r12, r0, 1
; CHECK-NEXT: sw r12, 0(r6)
; CHECK-NEXT: .LBB3_2:
; CHECK-NEXT: ret
  %r = icmp sge i32 %a, %b
  br i1 %r, label %yes, label %no
yes:
  store i32 1, ptr %p
  ret void
no:
  ret void
}
define void @sgt(i32 %a, i32 %b, ptr %p) {
; CHECK-LABEL: sgt:
; CHECK: bge r5, r4, .LBB4_2
; CHECK: addi r12, r0, 1
; CHECK-NEXT: sw r12, 0(r6)
; CHECK-NEXT: .LBB4_2:
; CHECK-NEXT: ret
  %r = icmp sgt i32 %a, %b
  br i1 %r, label %yes, label %no
yes:
  store i32 1, ptr %p
  ret void
no:
  ret void
}
define void @sle(i32 %a, i32 %b, ptr %p) {
; CHECK-LABEL: sle:
; CHECK: blt r5, r4, .LBB5_2
; CHECK: addi r12, r0, 1
; CHECK-NEXT: sw r12, 0(r6)
; CHECK-NEXT: .LBB5_2:
; CHECK-NEXT: ret
  %r = icmp sle i32 %a, %b
  br i1 %r, label %yes, label %no
yes:
  store i32 1, ptr %p
  ret void
no:
  ret void
}
define void @ult(i32 %a, i32 %b, ptr %p) {
; CHECK-LABEL: ult:
; CHECK: bgeu r4, r5, .LBB6_2
; CHECK: addi r12, r0, 1
; CHECK-NEXT: sw r12, 0(r6)
; CHECK-NEXT: .LBB6_2:
; CHECK-NEXT: ret
  %r = icmp ult i32 %a, %b
  br i1 %r, label %yes, label %no
yes:
  store i32 1, ptr %p
  ret void
no:
  ret void
}
define void @uge(i32 %a, i32 %b, ptr %p) {
; CHECK-LABEL: uge:
; CHECK: bltu r4, r5, .LBB7_2
; CHECK: addi r12, r0, 1
; CHECK-NEXT: sw r12, 0(r6)
; CHECK-NEXT: .LBB7_2:
; CHECK-NEXT: ret
  %r = icmp uge i32 %a, %b
  br i1 %r, label %yes, label %no
yes:
  store i32 1, ptr %p
  ret void
no:
  ret void
}
define void @ugt(i32 %a, i32 %b, ptr %p) {
; CHECK-LABEL: ugt:
; CHECK: bgeu r5, r4, .LBB8_2
; CHECK: addi r12, r0, 1
; CHECK-NEXT: sw r12, 0(r6)
; CHECK-NEXT: .LBB8_2:
; CHECK-NEXT: ret
  %r = icmp ugt i32 %a, %b
  br i1 %r, label %yes, label %no
yes:
  store i32 1, ptr %p
  ret void
no:
  ret void
}
define void @ule(i32 %a, i32 %b, ptr %p) {
; CHECK-LABEL: ule:
; CHECK: bltu r5, r4, .LBB9_2
; CHECK: addi r12, r0, 1
; CHECK-NEXT: sw r12, 0(r6)
; CHECK-NEXT: .LBB9_2:
; CHECK-NEXT: ret
  %r = icmp ule i32 %a, %b
  br i1 %r, label %yes, label %no
yes:
  store i32 1, ptr %p
  ret void
no:
  ret void
}
define void @immediate(i32 %a, ptr %p) {
; CHECK-LABEL: immediate:
; CHECK: addi r12, r0, 99
; CHECK-NEXT: blt r12, r4, .LBB10_2
; CHECK: addi r12, r0, 1
; CHECK-NEXT: sw r12, 0(r5)
; CHECK-NEXT: .LBB10_2:
; CHECK-NEXT: ret
  %r = icmp slt i32 %a, 100
  br i1 %r, label %yes, label %no
yes:
  store i32 1, ptr %p
  ret void
no:
  ret void
}
define void @zero(i32 %a, ptr %p) {
; CHECK-LABEL: zero:
; CHECK: blt r4, r0, .LBB11_2
; CHECK: ret
; CHECK-NEXT: .LBB11_2:
; CHECK-NEXT: addi r12, r0, 1
; CHECK-NEXT: sw r12, 0(r5)
; CHECK-NEXT: ret
  %r = icmp slt i32 %a, 0
  br i1 %r, label %yes, label %no
yes:
  store i32 1, ptr %p
  ret void
no:
  ret void
}
define i32 @loop(i32 %n) {
; CHECK-LABEL: loop:
; CHECK: move r13, r0
; CHECK-NEXT: move r12, r0
; CHECK-NEXT: .LBB12_1:
; CHECK: mul r12, r12, r13
; CHECK-NEXT: addi r13, r13, 1
; CHECK-NEXT: bltu r13, r4, .LBB12_1
; CHECK: move r4, r12
; CHECK-NEXT: ret
entry:
  br label %head
head:
  %i = phi i32 [ 0, %entry ], [ %j, %head ]
  %s = phi i32 [ 0, %entry ], [ %t, %head ]
  %t = mul i32 %s, %i
  %j = add i32 %i, 1
  %c = icmp ult i32 %j, %n
  br i1 %c, label %head, label %exit
exit:
  ret i32 %t
}
define i32 @indirect(i32 %i) {
; CHECK-LABEL: indirect:
; CHECK: lui r12, %hi(targets)
; CHECK-NEXT: addi r12, r12, %lo(targets)
; CHECK-NEXT: sll r13, r4, 2
; CHECK-NEXT: lwx r12, r12(r13)
; CHECK-NEXT: jr r12
; CHECK: .LBB13_1:
; CHECK-NEXT: addi r4, r0, 1
; CHECK-NEXT: ret
; CHECK: .LBB13_2:
; CHECK-NEXT: addi r4, r0, 2
; CHECK-NEXT: ret
  %p = getelementptr [2 x ptr], ptr @targets, i32 0, i32 %i
  %t = load ptr, ptr %p
  indirectbr ptr %t, [label %one, label %two]
one:
  ret i32 1
two:
  ret i32 2
}
@targets = internal constant [2 x ptr] [ptr blockaddress(@indirect, %one), ptr blockaddress(@indirect, %two)]
define ptr @address() {
; CHECK-LABEL: address:
; CHECK: lui r12, %hi(.Ltmp0)
; CHECK-NEXT: addi r4, r12, %lo(.Ltmp0)
; CHECK-NEXT: ret
  ret ptr blockaddress(@indirect, %one)
}
define void @traps(i1 %c) {
; CHECK-LABEL: traps:
; CHECK: andi r12, r4, 1
; CHECK-NEXT: bne r12, r0, .LBB15_2
; CHECK: break 1
; CHECK-NEXT: ret
; CHECK-NEXT: .LBB15_2:
; CHECK-NEXT: break 0
  br i1 %c, label %a, label %b
a:
  call void @llvm.trap()
  unreachable
b:
  call void @llvm.debugtrap()
  ret void
}
