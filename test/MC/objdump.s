# RUN: tp-mc -filetype=obj %s -o %t.o
# RUN: tp-objdump -d %t.o | FileCheck %s
# RUN: tp-objdump -dr %t.o | FileCheck --check-prefix=RELOC %s
# RUN: tp-objdump -h -t %t.o | FileCheck --check-prefix=TABLES %s
# RUN: tp-objdump --disassemble --no-aliases %t.o | FileCheck --check-prefix=PLAIN %s

# CHECK: objdump.s.tmp.o: file format elf32-tp
# CHECK: Disassembly of section .text:
# CHECK-EMPTY:
# CHECK-NEXT: 00000000 <main>:
# CHECK-NEXT: 0: 20800005 addi r4, r0, 5
# CHECK-NEXT: 4: e4000004 jal 0x14 <local>
# CHECK-NEXT: 8: c0800002 beq r4, r0, 0x10 <main+0x10>
# CHECK-NEXT: c: e4000000 jal callee
# CHECK-NEXT: 10: 101f0001 ret
# CHECK-EMPTY:
# CHECK-NEXT: 00000014 <local>:
# CHECK-NEXT: 14: 38a00000 lui r5, %hi(table+8)
# CHECK-NEXT: 18: 90a50000 lw r5, %lo(table+8)(r5)
# CHECK-NEXT: 1c: 00000000 .4byte 0x00000000
# CHECK-NEXT: 20: e3fffff8 j 0x0 <main>
# CHECK-NEXT: 24: 07 .byte 0x07
# CHECK: Disassembly of section .text.other:
# CHECK: 0: 20000000 nop

# RELOC: jal callee
# RELOC-NEXT: 0000000c: R_TP_PC26 callee
# RELOC: lui r5, %hi(table+8)
# RELOC-NEXT: 00000014: R_TP_HI16 table+0x8

# PLAIN: jr r31

# TABLES: Idx Name Size Address Type
# TABLES: .text 00000025 00000000 TEXT
# TABLES: .data 00000004 00000000 DATA
# TABLES: .bss 00000008 00000000 BSS
# TABLES: 00000014 l .text 00000000 local
# TABLES: 00000000 g function .text 00000014 main
# TABLES: 00000000 g *UND* 00000000 callee
# TABLES: 00000007 g *ABS* 00000000 constant
# TABLES: 00000000 w object .data 00000004 variable
.globl main
.type main,@function
main:
addi r4, r0, 5
jal local
beqz r4, 1f
jal callee
1:
ret
.size main, . - main
local:
lui r5, %hi(table+8)
lw r5, %lo(table+8)(r5)
.4byte 0
j (local - 0x14)
.byte 7
.globl constant
constant = 7
.data
.weak variable
.type variable,@object
.size variable, 4
variable: .4byte 0
.bss
.space 8
.section .text.other,"ax",@progbits
nop
