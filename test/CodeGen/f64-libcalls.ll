; RUN: %llc_tp -O2 -verify-machineinstrs < %s | FileCheck %s
; RUN: %llc_tp -O0 -verify-machineinstrs -filetype=obj -o %t.o < %s

define double @arithmetic(double %a, double %b) {
; CHECK-LABEL: arithmetic:
; CHECK: addi r29, r29, -16
; CHECK-NEXT: sw r31, 12(r29)
; CHECK-NEXT: sw r16, 8(r29)
; CHECK-NEXT: sw r17, 4(r29)
; CHECK-NEXT: move r16, r7
; CHECK-NEXT: move r17, r6
; CHECK-NEXT: jal __adddf3
; CHECK-NEXT: move r6, r17
; CHECK-NEXT: move r7, r16
; CHECK-NEXT: jal __subdf3
; CHECK-NEXT: move r6, r17
; CHECK-NEXT: move r7, r16
; CHECK-NEXT: jal __muldf3
; CHECK-NEXT: move r6, r17
; CHECK-NEXT: move r7, r16
; CHECK-NEXT: jal __divdf3
; CHECK-NEXT: lw r17, 4(r29)
; CHECK-NEXT: lw r16, 8(r29)
; CHECK-NEXT: lw r31, 12(r29)
; CHECK-NEXT: addi r29, r29, 16
; CHECK-NEXT: ret
  %c = fadd double %a, %b
  %d = fsub double %c, %b
  %e = fmul double %d, %b
  %f = fdiv double %e, %b
  ret double %f
}
define i1 @less(double %a, double %b) {
; CHECK-LABEL: less:
; CHECK: addi r29, r29, -8
; CHECK-NEXT: sw r31, 4(r29)
; CHECK-NEXT: jal __ltdf2
; CHECK-NEXT: lw r31, 4(r29)
; CHECK-NEXT: slti r4, r4, 0
; CHECK-NEXT: addi r29, r29, 8
; CHECK-NEXT: ret
  %r = fcmp olt double %a, %b
  ret i1 %r
}
define i1 @unordered_equal(double %a, double %b) {
; CHECK-LABEL: unordered_equal:
; CHECK: addi r29, r29, -24
; CHECK-NEXT: sw r31, 20(r29)
; CHECK-NEXT: sw r16, 16(r29)
; CHECK-NEXT: sw r17, 12(r29)
; CHECK-NEXT: sw r18, 8(r29)
; CHECK-NEXT: sw r19, 4(r29)
; CHECK-NEXT: sw r20, 0(r29)
; CHECK-NEXT: move r17, r7
; CHECK-NEXT: move r18, r6
; CHECK-NEXT: move r19, r5
; CHECK-NEXT: move r20, r4
; CHECK-NEXT: jal __unorddf2
; CHECK-NEXT: move r16, r4
; CHECK-NEXT: move r4, r20
; CHECK-NEXT: move r5, r19
; CHECK-NEXT: move r6, r18
; CHECK-NEXT: move r7, r17
; CHECK-NEXT: jal __eqdf2
; CHECK-NEXT: sltiu r12, r4, 1
; CHECK-NEXT: or r4, r16, r12
; CHECK-NEXT: lw r20, 0(r29)
; CHECK-NEXT: lw r19, 4(r29)
; CHECK-NEXT: lw r18, 8(r29)
; CHECK-NEXT: lw r17, 12(r29)
; CHECK-NEXT: lw r16, 16(r29)
; CHECK-NEXT: lw r31, 20(r29)
; CHECK-NEXT: addi r29, r29, 24
; CHECK-NEXT: ret
  %r = fcmp ueq double %a, %b
  ret i1 %r
}
define double @widen(float %a) {
; CHECK-LABEL: widen:
; CHECK: addi r29, r29, -8
; CHECK-NEXT: sw r31, 4(r29)
; CHECK-NEXT: jal __extendsfdf2
; CHECK-NEXT: lw r31, 4(r29)
; CHECK-NEXT: addi r29, r29, 8
; CHECK-NEXT: ret
  %r = fpext float %a to double
  ret double %r
}
define float @narrow(double %a) {
; CHECK-LABEL: narrow:
; CHECK: addi r29, r29, -8
; CHECK-NEXT: sw r31, 4(r29)
; CHECK-NEXT: jal __truncdfsf2
; CHECK-NEXT: lw r31, 4(r29)
; CHECK-NEXT: addi r29, r29, 8
; CHECK-NEXT: ret
  %r = fptrunc double %a to float
  ret float %r
}
define i32 @to_int(double %a) {
; CHECK-LABEL: to_int:
; CHECK: addi r29, r29, -8
; CHECK-NEXT: sw r31, 4(r29)
; CHECK-NEXT: jal __fixdfsi
; CHECK-NEXT: lw r31, 4(r29)
; CHECK-NEXT: addi r29, r29, 8
; CHECK-NEXT: ret
  %r = fptosi double %a to i32
  ret i32 %r
}
define double @from_unsigned(i32 %a) {
; CHECK-LABEL: from_unsigned:
; CHECK: addi r29, r29, -8
; CHECK-NEXT: sw r31, 4(r29)
; CHECK-NEXT: jal __floatunsidf
; CHECK-NEXT: lw r31, 4(r29)
; CHECK-NEXT: addi r29, r29, 8
; CHECK-NEXT: ret
  %r = uitofp i32 %a to double
  ret double %r
}
define double @sign(double %a, double %b) {
; CHECK-LABEL: sign:
; CHECK: ins r7, r5, 0, 30
; CHECK-NEXT: move r5, r7
; CHECK-NEXT: ret
  %c = fneg double %a
  %d = call double @llvm.fabs.f64(double %c)
  %e = call double @llvm.copysign.f64(double %d, double %b)
  ret double %e
}
define double @root(double %a) {
; CHECK-LABEL: root:
; CHECK: addi r29, r29, -8
; CHECK-NEXT: sw r31, 4(r29)
; CHECK-NEXT: jal sqrt
; CHECK-NEXT: lw r31, 4(r29)
; CHECK-NEXT: addi r29, r29, 8
; CHECK-NEXT: ret
  %b = call double @llvm.sqrt.f64(double %a)
  ret double %b
}
define double @constant() {
; CHECK-LABEL: constant:
; CHECK: lui r12, 39321
; CHECK-NEXT: ori r4, r12, 39322
; CHECK-NEXT: lui r12, 16369
; CHECK-NEXT: ori r5, r12, 39321
; CHECK-NEXT: ret
  ret double 1.1
}
define half @halves(half %a, half %b) {
; CHECK-LABEL: halves:
; CHECK: addi r29, r29, -16
; CHECK-NEXT: sw r31, 12(r29)
; CHECK-NEXT: sw r16, 8(r29)
; CHECK-NEXT: swc1 f20, 4(r29)
; CHECK-NEXT: move r16, r4
; CHECK-NEXT: move r4, r5
; CHECK-NEXT: jal __extendhfsf2
; CHECK-NEXT: move r4, r16
; CHECK-NEXT: mov_s f20, f4
; CHECK-NEXT: jal __extendhfsf2
; CHECK-NEXT: add_s f4, f4, f20
; CHECK-NEXT: jal __truncsfhf2
; CHECK-NEXT: lwc1 f20, 4(r29)
; CHECK-NEXT: lw r16, 8(r29)
; CHECK-NEXT: lw r31, 12(r29)
; CHECK-NEXT: addi r29, r29, 16
; CHECK-NEXT: ret
  %c = fadd half %a, %b
  ret half %c
}
; The runtime's fmin and fmax order zeros and prefer numbers.
define double @extremes(double %a, double %b) {
; CHECK-LABEL: extremes:
; CHECK: addi r29, r29, -16
; CHECK-NEXT: sw r31, 12(r29)
; CHECK-NEXT: sw r16, 8(r29)
; CHECK-NEXT: sw r17, 4(r29)
; CHECK-NEXT: move r16, r7
; CHECK-NEXT: move r17, r6
; CHECK-NEXT: jal fmin
; CHECK-NEXT: move r6, r17
; CHECK-NEXT: move r7, r16
; CHECK-NEXT: jal fmax
; CHECK-NEXT: lw r17, 4(r29)
; CHECK-NEXT: lw r16, 8(r29)
; CHECK-NEXT: lw r31, 12(r29)
; CHECK-NEXT: addi r29, r29, 16
; CHECK-NEXT: ret
  %c = call double @llvm.minimumnum.f64(double %a, double %b)
  %d = call double @llvm.maximumnum.f64(double %c, double %b)
  ret double %d
}
