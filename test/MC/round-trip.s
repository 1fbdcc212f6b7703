# What --assembly prints makes the same object: labels, targets, relocations,
# symbols, words that are no instructions.
# RUN: tp-mc -filetype=obj %s -o %t.o
# RUN: tp-objdump --assembly %t.o > %t.s
# RUN: tp-mc -filetype=obj %t.s -o %t.again.o
# RUN: cmp %t.o %t.again.o
# RUN: FileCheck %s < %t.s

# CHECK: .section .text,"ax",@progbits
# CHECK-NEXT: .globl main
# CHECK-NEXT: .type main,@function
# CHECK-NEXT: .size main, 56
# CHECK-NEXT: main:
.text
.globl main
.type main,@function
main:
addi sp, sp, -16
.Lloop:
# CHECK: beq r4, r0, .Lat_14
beqz r4, .Lend
# CHECK: bltzal r5, .Lat_4
bltzal r5, .Lloop
j .Lloop
jal .Lend
.Lend:
# CHECK: jal main
jal main
# CHECK-NEXT: j callee+8
j callee + 8
beq r6, r7, callee - 4
lui r4, %hi(table + 0x12345)
lwc1 f4, %lo(table + 0x12345)(r4)
addi r4, r4, %lo(table)
# CHECK: .4byte 0x12345678
.4byte 0x12345678
# CHECK-NEXT: .4byte table+0x4
.4byte table + 4
# CHECK-NEXT: j 134217724
j 134217724
.size main, 56
.weak helper
helper:
ret
# CHECK: .byte 0x01
.byte 1
