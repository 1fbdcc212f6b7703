# Shifts by a constant and bit fields.
# The expected bytes were worked out by hand from the format:
# R: opcode 31-26, a 25-21, b 20-16, c 15-11, d 10-6, funct 5-0
#
# RUN: tp-mc -no-aliases -show-encoding %s | FileCheck %s
#
# Round trip: the object's disassembly makes the same object.
# RUN: tp-mc -filetype=obj %s -o %t.o
# RUN: tp-objdump --assembly %t.o > %t.again.s
# RUN: tp-mc -filetype=obj %t.again.s -o %t.again.o
# RUN: cmp %t.o %t.again.o
# RUN: tp-objdump --assembly -no-aliases %t.o > %t.plain.s
# RUN: tp-mc -filetype=obj %t.plain.s -o %t.plain.o
# RUN: cmp %t.o %t.plain.o

# CHECK: sll r17, r2, 0 # encoding: [0x20,0x00,0x22,0x02]
sll r17, r2, 0
# CHECK: sll r31, r16, 31 # encoding: [0x20,0xf8,0xf0,0x03]
sll r31, r16, 31
# CHECK: sll r10, r13, 18 # encoding: [0x20,0x90,0x4d,0x01]
sll r10, r13, 18

# CHECK: srl r17, r2, 0 # encoding: [0x21,0x00,0x22,0x02]
srl r17, r2, 0
# CHECK: srl r31, r16, 31 # encoding: [0x21,0xf8,0xf0,0x03]
srl r31, r16, 31
# CHECK: srl r10, r13, 18 # encoding: [0x21,0x90,0x4d,0x01]
srl r10, r13, 18

# CHECK: sra r17, r2, 0 # encoding: [0x22,0x00,0x22,0x02]
sra r17, r2, 0
# CHECK: sra r31, r16, 31 # encoding: [0x22,0xf8,0xf0,0x03]
sra r31, r16, 31
# CHECK: sra r10, r13, 18 # encoding: [0x22,0x90,0x4d,0x01]
sra r10, r13, 18

# CHECK: rotr r17, r2, 0 # encoding: [0x23,0x00,0x22,0x02]
rotr r17, r2, 0
# CHECK: rotr r31, r16, 31 # encoding: [0x23,0xf8,0xf0,0x03]
rotr r31, r16, 31
# CHECK: rotr r10, r13, 18 # encoding: [0x23,0x90,0x4d,0x01]
rotr r10, r13, 18

# CHECK: ext r17, r2, 0, 31 # encoding: [0xeb,0x07,0x22,0x02]
ext r17, r2, 0, 31
# CHECK: ext r31, r16, 31, 31 # encoding: [0xeb,0xff,0xf0,0x03]
ext r31, r16, 31, 31
# CHECK: ext r10, r13, 5, 18 # encoding: [0xab,0x2c,0x4d,0x01]
ext r10, r13, 5, 18
# CHECK: ext r5, r9, 0, 0 # encoding: [0x2b,0x00,0xa9,0x00]
ext r5, r9, 0, 0

# CHECK: ins r17, r2, 0, 31 # encoding: [0xec,0x07,0x22,0x02]
ins r17, r2, 0, 31
# CHECK: ins r31, r16, 31, 31 # encoding: [0xec,0xff,0xf0,0x03]
ins r31, r16, 31, 31
# CHECK: ins r10, r13, 5, 18 # encoding: [0xac,0x2c,0x4d,0x01]
ins r10, r13, 5, 18
# CHECK: ins r5, r9, 0, 0 # encoding: [0x2c,0x00,0xa9,0x00]
ins r5, r9, 0, 0
