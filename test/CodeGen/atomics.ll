; RUN: %llc_tp -O2 -verify-machineinstrs < %s | FileCheck %s
; RUN: %llc_tp -O0 -verify-machineinstrs -filetype=obj -o %t.o < %s

define i32 @add(ptr %p, i32 %v) {
; CHECK-LABEL: add:
; CHECK: atom_add r4, r5, (r4)
; CHECK-NEXT: ret
  %r = atomicrmw add ptr %p, i32 %v monotonic
  ret i32 %r
}
define i32 @sub(ptr %p, i32 %v) {
; CHECK-LABEL: sub:
; CHECK: neg r12, r5
; CHECK-NEXT: atom_add r4, r12, (r4)
; CHECK-NEXT: ret
  %r = atomicrmw sub ptr %p, i32 %v monotonic
  ret i32 %r
}
define i32 @others(ptr %p, i32 %v) {
; CHECK-LABEL: others:
; CHECK: atom_and r12, r5, (r4)
; CHECK-NEXT: atom_or r12, r12, (r4)
; CHECK-NEXT: atom_xor r12, r12, (r4)
; CHECK-NEXT: atom_min r12, r12, (r4)
; CHECK-NEXT: atom_max r12, r12, (r4)
; CHECK-NEXT: atom_minu r12, r12, (r4)
; CHECK-NEXT: atom_maxu r12, r12, (r4)
; CHECK-NEXT: atom_swap r4, r12, (r4)
; CHECK-NEXT: ret
  %a = atomicrmw and ptr %p, i32 %v monotonic
  %b = atomicrmw or ptr %p, i32 %a monotonic
  %c = atomicrmw xor ptr %p, i32 %b monotonic
  %d = atomicrmw min ptr %p, i32 %c monotonic
  %e = atomicrmw max ptr %p, i32 %d monotonic
  %f = atomicrmw umin ptr %p, i32 %e monotonic
  %g = atomicrmw umax ptr %p, i32 %f monotonic
  %h = atomicrmw xchg ptr %p, i32 %g monotonic
  ret i32 %h
}
define i32 @nand(ptr %p, i32 %v) {
; CHECK-LABEL: nand:
; CHECK: move r12, r4
; CHECK: lw r4, 0(r12)
; CHECK-NEXT: .LBB3_1:
; CHECK: move r13, r4
; CHECK-NEXT: and r14, r13, r5
; CHECK-NEXT: not r14, r14
; CHECK-NEXT: atom_cas r4, r14, (r12)
; CHECK-NEXT: bne r4, r13, .LBB3_1
; CHECK: ret
  %r = atomicrmw nand ptr %p, i32 %v monotonic
  ret i32 %r
}
define float @fadd(ptr %p, float %v) {
; CHECK-LABEL: fadd:
; CHECK: lwc1 f12, 0(r4)
; CHECK-NEXT: .LBB4_1:
; CHECK: add_s f13, f12, f4
; CHECK-NEXT: mfc1 r12, f12
; CHECK-NEXT: mfc1 r14, f13
; CHECK-NEXT: move r13, r12
; CHECK-NEXT: atom_cas r13, r14, (r4)
; CHECK-NEXT: mtc1 f12, r13
; CHECK-NEXT: bne r13, r12, .LBB4_1
; CHECK: mov_s f4, f12
; CHECK-NEXT: ret
  %r = atomicrmw fadd ptr %p, float %v monotonic
  ret float %r
}
define float @exchange_float(ptr %p, float %v) {
; CHECK-LABEL: exchange_float:
; CHECK: mfc1 r12, f4
; CHECK-NEXT: atom_swap r12, r12, (r4)
; CHECK-NEXT: mtc1 f4, r12
; CHECK-NEXT: ret
  %r = atomicrmw xchg ptr %p, float %v monotonic
  ret float %r
}
define i8 @add_byte(ptr %p, i8 %v) {
; CHECK-LABEL: add_byte:
; CHECK: addi r12, r0, -4
; CHECK-NEXT: and r12, r4, r12
; CHECK: lw r13, 0(r12)
; CHECK-NEXT: sll r14, r4, 3
; CHECK-NEXT: andi r14, r14, 24
; CHECK-NEXT: addi r15, r0, 255
; CHECK-NEXT: sllv r15, r15, r14
; CHECK-NEXT: andi r25, r5, 255
; CHECK-NEXT: not r24, r15
; CHECK-NEXT: sllv r25, r25, r14
; CHECK-NEXT: .LBB6_1:
; CHECK: move r26, r13
; CHECK-NEXT: add r27, r26, r25
; CHECK-NEXT: and r27, r27, r15
; CHECK-NEXT: and r28, r26, r24
; CHECK-NEXT: or r27, r28, r27
; CHECK: atom_cas r13, r27, (r12)
; CHECK-NEXT: bne r13, r26, .LBB6_1
; CHECK: srlv r4, r13, r14
; CHECK-NEXT: ret
  %r = atomicrmw add ptr %p, i8 %v monotonic
  ret i8 %r
}
define i1 @compare_exchange(ptr %p, i32 %old, i32 %new) {
; CHECK-LABEL: compare_exchange:
; CHECK: move r12, r5
; CHECK-NEXT: atom_cas r12, r6, (r4)
; CHECK-NEXT: xor r12, r12, r5
; CHECK-NEXT: sltiu r4, r12, 1
; CHECK-NEXT: ret
  %r = cmpxchg ptr %p, i32 %old, i32 %new monotonic monotonic
  %s = extractvalue { i32, i1 } %r, 1
  ret i1 %s
}
define i16 @compare_exchange_half(ptr %p, i16 %old, i16 %new) {
; CHECK-LABEL: compare_exchange_half:
; CHECK: addi r12, r0, -4
; CHECK-NEXT: and r12, r4, r12
; CHECK-NEXT: sync
; CHECK: lw r25, 0(r12)
; CHECK-NEXT: sll r13, r4, 3
; CHECK-NEXT: andi r13, r13, 24
; CHECK-NEXT: ori r14, r0, 65535
; CHECK-NEXT: sllv r14, r14, r13
; CHECK-NEXT: not r14, r14
; CHECK-NEXT: andi r15, r6, 65535
; CHECK-NEXT: andi r24, r5, 65535
; CHECK-NEXT: sllv r15, r15, r13
; CHECK-NEXT: sllv r24, r24, r13
; CHECK-NEXT: and r27, r25, r14
; CHECK-NEXT: .LBB8_1:
; CHECK: move r25, r27
; CHECK-NEXT: or r27, r25, r24
; CHECK-NEXT: or r28, r25, r15
; CHECK-NEXT: move r26, r27
; CHECK: atom_cas r26, r28, (r12)
; CHECK-NEXT: beq r26, r27, .LBB8_3
; CHECK: and r27, r26, r14
; CHECK-NEXT: bne r25, r27, .LBB8_1
; CHECK-NEXT: .LBB8_3:
; CHECK-NEXT: srlv r4, r26, r13
; CHECK-NEXT: sync
; CHECK-NEXT: ret
  %r = cmpxchg ptr %p, i16 %old, i16 %new seq_cst seq_cst
  %s = extractvalue { i16, i1 } %r, 0
  ret i16 %s
}
define i32 @load_acquire(ptr %p) {
; CHECK-LABEL: load_acquire:
; CHECK: lw r4, 0(r4)
; CHECK-NEXT: ret
  %r = load atomic i32, ptr %p acquire, align 4
  ret i32 %r
}
define void @store_release(ptr %p, i32 %v) {
; CHECK-LABEL: store_release:
; CHECK: sync
; CHECK: sw r5, 0(r4)
; CHECK-NEXT: ret
  store atomic i32 %v, ptr %p release, align 4
  ret void
}
define void @store_seq_cst(ptr %p, i8 %v) {
; CHECK-LABEL: store_seq_cst:
; CHECK: sync
; CHECK: sb r5, 0(r4)
; CHECK-NEXT: sync
; CHECK-NEXT: ret
  store atomic i8 %v, ptr %p seq_cst, align 1
  ret void
}
define i32 @acquire_release(ptr %p, i32 %v) {
; CHECK-LABEL: acquire_release:
; CHECK: sync
; CHECK-NEXT: atom_add r4, r5, (r4)
; CHECK-NEXT: sync
; CHECK-NEXT: ret
  %r = atomicrmw add ptr %p, i32 %v acq_rel
  ret i32 %r
}
define void @fences() {
; CHECK-LABEL: fences:
; CHECK: sync
; CHECK: ret
  fence seq_cst
  fence syncscope("singlethread") seq_cst
  ret void
}
define i64 @add_long(ptr %p, i64 %v) {
; CHECK-LABEL: add_long:
; CHECK: addi r29, r29, -8
; CHECK-NEXT: sw r31, 4(r29)
; CHECK-NEXT: addi r7, r0, 5
; CHECK-NEXT: jal __atomic_fetch_add_8
; CHECK-NEXT: lw r31, 4(r29)
; CHECK-NEXT: addi r29, r29, 8
; CHECK-NEXT: ret
  %r = atomicrmw add ptr %p, i64 %v seq_cst
  ret i64 %r
}
define float @load_float(ptr %p) {
; CHECK-LABEL: load_float:
; CHECK: lw r12, 0(r4)
; CHECK-NEXT: mtc1 f4, r12
; CHECK-NEXT: ret
  %r = load atomic float, ptr %p monotonic, align 4
  ret float %r
}
