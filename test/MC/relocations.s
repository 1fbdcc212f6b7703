# RUN: tp-mc -filetype=obj %s -o %t.o
# RUN: tp-objdump -r %t.o | FileCheck %s
# RUN: llvm-readobj -h -r %t.o | FileCheck --check-prefix=STOCK %s

# STOCK: Format: elf32-unknown
# STOCK: Class: 32-bit
# STOCK: DataEncoding: LittleEndian
# STOCK: Machine: 0x5450

# CHECK: Relocations of .text:
# STOCK: Section ({{.*}}) .rela.text
# CHECK-NEXT: 00000000 R_TP_HI16 symbol+0x8
# STOCK-NEXT: 0x0 Unknown symbol 0x8
lui r4, %hi(symbol + 8)
# CHECK-NEXT: 00000004 R_TP_LO16 symbol-0x8
# STOCK-NEXT: 0x4 Unknown symbol 0xFFFFFFF8
addi r4, r4, %lo(symbol - 8)
# CHECK-NEXT: 00000008 R_TP_PC16 symbol
beq r4, r5, symbol
# CHECK-NEXT: 0000000c R_TP_PC16 symbol
bltzal r4, symbol
# CHECK-NEXT: 00000010 R_TP_PC26 symbol+0x10
j symbol + 16
# CHECK-NEXT: 00000014 R_TP_PC26 symbol
jal symbol

# A global may be replaced, a local may not.
# CHECK-NEXT: 00000018 R_TP_PC26 global
# CHECK-NOT: 0000001c
# CHECK-NOT: 00000020
.globl global
global:
local:
j global
j local
# Another section's local symbol is its section and an offset...
# CHECK: 00000020 R_TP_PC26 .text.other+0x4
j other

# CHECK: Relocations of .data:
# CHECK-NEXT: 00000000 R_TP_32 symbol+0x4
# CHECK-NEXT: 00000004 R_TP_PC32 symbol
# CHECK-NEXT: 00000008 R_TP_16 symbol
# CHECK-NEXT: 0000000a R_TP_8 symbol+0x1
# CHECK-NEXT: 0000000c R_TP_32 .rodata.str1.1+0x3
# CHECK-NEXT: 00000010 R_TP_32 .Lsecond+0x1
# CHECK-NEXT: 00000014 R_TP_NONE *ABS*
# CHECK-NEXT: 00000018 R_TP_HI16 symbol
.data
.4byte symbol + 4
.4byte symbol - .
.2byte symbol
.byte symbol + 1
.byte 0
.4byte .Lsecond
# ... but an offset into mergeable strings keeps the symbol.
.4byte .Lsecond + 1
.4byte 0
.reloc 0x14, R_TP_NONE
.4byte 0
.reloc 0x18, R_TP_HI16, symbol

.section .text.other,"ax",@progbits
nop
other:
nop
.section .rodata.str1.1,"aMS",@progbits,1
.asciz "ab"
.Lsecond:
.asciz "cd"
