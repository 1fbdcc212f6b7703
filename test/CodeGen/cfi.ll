; RUN: %llc_tp -O2 -verify-machineinstrs -force-dwarf-frame-section < %s | FileCheck %s
; RUN: %llc_tp -O0 -verify-machineinstrs -filetype=obj -o %t.o < %s

declare void @use(ptr)
define i32 @frame(i32 %n) uwtable {
; CHECK-LABEL: frame:
; CHECK: .cfi_sections .eh_frame, .debug_frame
; CHECK: addi r29, r29, -24
; CHECK-NEXT: .cfi_def_cfa_offset 24
; CHECK-NEXT: sw r31, 20(r29)
; CHECK-NEXT: sw r16, 16(r29)
; CHECK-NEXT: .cfi_offset r31, -4
; CHECK-NEXT: .cfi_offset r16, -8
; CHECK-NEXT: move r16, r4
; CHECK-NEXT: move r4, r29
; CHECK-NEXT: jal use
; CHECK-NEXT: move r4, r16
; CHECK-NEXT: lw r16, 16(r29)
; CHECK-NEXT: lw r31, 20(r29)
; CHECK-NEXT: .cfi_restore r31
; CHECK-NEXT: .cfi_restore r16
; CHECK-NEXT: addi r29, r29, 24
; CHECK-NEXT: .cfi_def_cfa_offset 0
; CHECK-NEXT: ret
  %a = alloca [4 x i32]
  call void @use(ptr %a)
  ret i32 %n
}
define i32 @frame_pointer(i32 %n) uwtable "frame-pointer"="all" {
; CHECK-LABEL: frame_pointer:
; CHECK: addi r29, r29, -32
; CHECK-NEXT: .cfi_def_cfa_offset 32
; CHECK-NEXT: sw r31, 28(r29)
; CHECK-NEXT: sw r30, 24(r29)
; CHECK-NEXT: sw r16, 20(r29)
; CHECK-NEXT: .cfi_offset r31, -4
; CHECK-NEXT: .cfi_offset r30, -8
; CHECK-NEXT: .cfi_offset r16, -12
; CHECK-NEXT: addi r30, r29, 32
; CHECK-NEXT: .cfi_def_cfa r30, 0
; CHECK-NEXT: move r16, r4
; CHECK-NEXT: addi r4, r30, -28
; CHECK-NEXT: jal use
; CHECK-NEXT: move r4, r16
; CHECK-NEXT: .cfi_def_cfa r29, 32
; CHECK-NEXT: lw r16, 20(r29)
; CHECK-NEXT: lw r30, 24(r29)
; CHECK-NEXT: lw r31, 28(r29)
; CHECK-NEXT: .cfi_restore r31
; CHECK-NEXT: .cfi_restore r30
; CHECK-NEXT: .cfi_restore r16
; CHECK-NEXT: addi r29, r29, 32
; CHECK-NEXT: .cfi_def_cfa_offset 0
; CHECK-NEXT: ret
  %a = alloca [4 x i32]
  call void @use(ptr %a)
  ret i32 %n
}
define i32 @early_return(i1 %c, i32 %n) uwtable {
; CHECK-LABEL: early_return:
; CHECK: addi r29, r29, -16
; CHECK-NEXT: .cfi_def_cfa_offset 16
; CHECK-NEXT: sw r31, 12(r29)
; CHECK-NEXT: sw r30, 8(r29)
; CHECK-NEXT: sw r16, 4(r29)
; CHECK-NEXT: .cfi_offset r31, -4
; CHECK-NEXT: .cfi_offset r30, -8
; CHECK-NEXT: .cfi_offset r16, -12
; CHECK-NEXT: addi r30, r29, 16
; CHECK-NEXT: .cfi_def_cfa r30, 0
; CHECK-NEXT: andi r12, r4, 1
; CHECK-NEXT: move r16, r5
; CHECK-NEXT: beq r12, r0, .LBB2_2
; CHECK: addi r4, r29, -16
; CHECK-NEXT: move r29, r4
; CHECK-NEXT: jal use
; CHECK-NEXT: .LBB2_2:
; CHECK-NEXT: move r4, r16
; CHECK-NEXT: addi r29, r30, -16
; CHECK-NEXT: .cfi_def_cfa r29, 16
; CHECK-NEXT: lw r16, 4(r29)
; CHECK-NEXT: lw r30, 8(r29)
; CHECK-NEXT: lw r31, 12(r29)
; CHECK-NEXT: .cfi_restore r31
; CHECK-NEXT: .cfi_restore r30
; CHECK-NEXT: .cfi_restore r16
; CHECK-NEXT: addi r29, r29, 16
; CHECK-NEXT: .cfi_def_cfa_offset 0
; CHECK-NEXT: ret
  br i1 %c, label %call, label %skip
call:
  %a = alloca [4 x i32]
  call void @use(ptr %a)
  br label %skip
skip:
  ret i32 %n
}
define i32 @two_returns(i32 %n) uwtable {
; CHECK-LABEL: two_returns:
; CHECK: addi r29, r29, -24
; CHECK-NEXT: .cfi_def_cfa_offset 24
; CHECK-NEXT: sw r31, 20(r29)
; CHECK-NEXT: sw r16, 16(r29)
; CHECK-NEXT: .cfi_offset r31, -4
; CHECK-NEXT: .cfi_offset r16, -8
; CHECK-NEXT: move r16, r4
; CHECK-NEXT: move r4, r29
; CHECK-NEXT: jal use
; CHECK-NEXT: addi r12, r0, 5
; CHECK-NEXT: bne r16, r12, .LBB3_2
; CHECK: move r4, r29
; CHECK-NEXT: jal use
; CHECK-NEXT: addi r4, r0, 1
; CHECK-NEXT: j .LBB3_3
; CHECK-NEXT: .LBB3_2:
; CHECK-NEXT: lw r4, 0(r29)
; CHECK-NEXT: .LBB3_3:
; CHECK-NEXT: lw r16, 16(r29)
; CHECK-NEXT: lw r31, 20(r29)
; CHECK-NEXT: .cfi_restore r31
; CHECK-NEXT: .cfi_restore r16
; CHECK-NEXT: addi r29, r29, 24
; CHECK-NEXT: .cfi_def_cfa_offset 0
; CHECK-NEXT: ret
  %a = alloca [4 x i32]
  call void @use(ptr %a)
  %c = icmp eq i32 %n, 5
  br i1 %c, label %call, label %skip
call:
  call void @use(ptr %a)
  ret i32 1
skip:
  %v = load volatile i32, ptr %a
  ret i32 %v
}
define ptr @addresses() "frame-pointer"="all" {
; CHECK-LABEL: addresses:
; CHECK: addi r29, r29, -16
; CHECK-NEXT: .cfi_def_cfa_offset 16
; CHECK-NEXT: sw r31, 12(r29)
; CHECK-NEXT: sw r30, 8(r29)
; CHECK-NEXT: sw r16, 4(r29)
; CHECK-NEXT: .cfi_offset r31, -4
; CHECK-NEXT: .cfi_offset r30, -8
; CHECK-NEXT: .cfi_offset r16, -12
; CHECK-NEXT: addi r30, r29, 16
; CHECK-NEXT: .cfi_def_cfa r30, 0
; CHECK-NEXT: lw r4, -8(r30)
; CHECK-NEXT: lw r16, -4(r4)
; CHECK-NEXT: jal use
; CHECK-NEXT: move r4, r16
; CHECK-NEXT: .cfi_def_cfa r29, 16
; CHECK-NEXT: lw r16, 4(r29)
; CHECK-NEXT: lw r30, 8(r29)
; CHECK-NEXT: lw r31, 12(r29)
; CHECK-NEXT: .cfi_restore r31
; CHECK-NEXT: .cfi_restore r30
; CHECK-NEXT: .cfi_restore r16
; CHECK-NEXT: addi r29, r29, 16
; CHECK-NEXT: .cfi_def_cfa_offset 0
; CHECK-NEXT: ret
  %f = call ptr @llvm.frameaddress(i32 1)
  %r = call ptr @llvm.returnaddress(i32 1)
  call void @use(ptr %f)
  ret ptr %r
}
define ptr @own_return_address() {
; CHECK-LABEL: own_return_address:
; CHECK: move r4, r31
; CHECK-NEXT: ret
  %r = call ptr @llvm.returnaddress(i32 0)
  ret ptr %r
}
