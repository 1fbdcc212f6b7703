; RUN: %llc_tp -O2 -verify-machineinstrs < %s | FileCheck %s
; RUN: %llc_tp -O0 -verify-machineinstrs -filetype=obj -o %t.o < %s

define i32 @registers(i32 %a, float %b) {
; CHECK-LABEL: registers:
; CHECK: neg_s f12, f4
; CHECK: trunc_w_s r13, f12
; CHECK: add r12, r4, r4
; CHECK: add r4, r12, r13
; CHECK-NEXT: ret
  %r = call i32 asm "add $0, $1, $2", "=r,r,r"(i32 %a, i32 %a)
  %s = call float asm "neg_s $0, $1", "=f,f"(float %b)
  %t = fptosi float %s to i32
  %u = add i32 %r, %t
  ret i32 %u
}
define i32 @immediates(i32 %a) {
; CHECK-LABEL: immediates:
; CHECK: addi r4, r4, -5
; CHECK-NEXT: ori r4, r4, 65535
; CHECK-NEXT: add r4, r4, r0
; CHECK: ret
  %r = call i32 asm "addi $0, $1, $2\0Aori $0, $0, $3\0Aadd $0, $0, ${4:z}", "=r,r,I,K,J"(i32 %a, i32 -5, i32 65535, i32 0)
  ret i32 %r
}
define i32 @memory(ptr %p) {
; CHECK-LABEL: memory:
; CHECK: lw r4, 12(r4)
; CHECK: ret
  %q = getelementptr i32, ptr %p, i32 3
  %r = call i32 asm "lw $0, $1", "=r,*m"(ptr elementtype(i32) %q)
  ret i32 %r
}
define void @local_memory(i32 %v) {
; CHECK-LABEL: local_memory:
; CHECK: addi r29, r29, -8
; CHECK-NEXT: addi r12, r29, 4
; CHECK: sw r4, 0(r12)
; CHECK: addi r29, r29, 8
; CHECK-NEXT: ret
  %a = alloca i32
  call void asm sideeffect "sw $1, $0", "=*m,r"(ptr elementtype(i32) %a, i32 %v)
  ret void
}
define i32 @named(i32 %x) {
; CHECK-LABEL: named:
; CHECK: move r7, r4
; CHECK: add r13, r7, r7
; CHECK: move r4, r13
; CHECK-NEXT: ret
  %r = call i32 asm "add $0, $1, $1", "={r13},{r7}"(i32 %x)
  ret i32 %r
}
define void @clobbers() {
; CHECK-LABEL: clobbers:
; CHECK: addi r29, r29, -8
; CHECK-NEXT: sw r16, 4(r29)
; CHECK-NEXT: swc1 f20, 0(r29)
; CHECK: nop
; CHECK: lwc1 f20, 0(r29)
; CHECK-NEXT: lw r16, 4(r29)
; CHECK-NEXT: addi r29, r29, 8
; CHECK-NEXT: ret
  call void asm sideeffect "nop", "~{r16},~{f20},~{memory}"()
  ret void
}
define i32 @stack_pointer() {
; CHECK-LABEL: stack_pointer:
; CHECK: move r4, r29
; CHECK-NEXT: ret
  %r = call i32 @llvm.read_register.i32(metadata !0)
  ret i32 %r
}
declare i32 @llvm.read_register.i32(metadata)
!0 = !{!"sp"}
