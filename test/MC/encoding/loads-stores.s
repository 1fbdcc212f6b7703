# Loads and stores.
# The expected bytes were worked out by hand from the format:
# I: opcode 31-26, a 25-21, b 20-16, immediate 15-0
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

# CHECK: lb r17, 0(r2) # encoding: [0x00,0x00,0x22,0x82]
lb r17, 0(r2)
# CHECK: lb r31, -32768(r16) # encoding: [0x00,0x80,0xf0,0x83]
lb r31, -32768(r16)
# CHECK: lb r10, 32767(r13) # encoding: [0xff,0x7f,0x4d,0x81]
lb r10, 32767(r13)

# CHECK: lbu r17, 0(r2) # encoding: [0x00,0x00,0x22,0x86]
lbu r17, 0(r2)
# CHECK: lbu r31, -32768(r16) # encoding: [0x00,0x80,0xf0,0x87]
lbu r31, -32768(r16)
# CHECK: lbu r10, 32767(r13) # encoding: [0xff,0x7f,0x4d,0x85]
lbu r10, 32767(r13)

# CHECK: lh r17, 0(r2) # encoding: [0x00,0x00,0x22,0x8a]
lh r17, 0(r2)
# CHECK: lh r31, -32768(r16) # encoding: [0x00,0x80,0xf0,0x8b]
lh r31, -32768(r16)
# CHECK: lh r10, 32767(r13) # encoding: [0xff,0x7f,0x4d,0x89]
lh r10, 32767(r13)

# CHECK: lhu r17, 0(r2) # encoding: [0x00,0x00,0x22,0x8e]
lhu r17, 0(r2)
# CHECK: lhu r31, -32768(r16) # encoding: [0x00,0x80,0xf0,0x8f]
lhu r31, -32768(r16)
# CHECK: lhu r10, 32767(r13) # encoding: [0xff,0x7f,0x4d,0x8d]
lhu r10, 32767(r13)

# CHECK: lw r17, 0(r2) # encoding: [0x00,0x00,0x22,0x92]
lw r17, 0(r2)
# CHECK: lw r31, -32768(r16) # encoding: [0x00,0x80,0xf0,0x93]
lw r31, -32768(r16)
# CHECK: lw r10, 32767(r13) # encoding: [0xff,0x7f,0x4d,0x91]
lw r10, 32767(r13)

# CHECK: lwc1 f17, 0(r2) # encoding: [0x00,0x00,0x22,0x96]
lwc1 f17, 0(r2)
# CHECK: lwc1 f31, -32768(r16) # encoding: [0x00,0x80,0xf0,0x97]
lwc1 f31, -32768(r16)
# CHECK: lwc1 f10, 32767(r13) # encoding: [0xff,0x7f,0x4d,0x95]
lwc1 f10, 32767(r13)

# CHECK: sb r17, 0(r2) # encoding: [0x00,0x00,0x22,0xa2]
sb r17, 0(r2)
# CHECK: sb r31, -32768(r16) # encoding: [0x00,0x80,0xf0,0xa3]
sb r31, -32768(r16)
# CHECK: sb r10, 32767(r13) # encoding: [0xff,0x7f,0x4d,0xa1]
sb r10, 32767(r13)

# CHECK: sh r17, 0(r2) # encoding: [0x00,0x00,0x22,0xa6]
sh r17, 0(r2)
# CHECK: sh r31, -32768(r16) # encoding: [0x00,0x80,0xf0,0xa7]
sh r31, -32768(r16)
# CHECK: sh r10, 32767(r13) # encoding: [0xff,0x7f,0x4d,0xa5]
sh r10, 32767(r13)

# CHECK: sw r17, 0(r2) # encoding: [0x00,0x00,0x22,0xaa]
sw r17, 0(r2)
# CHECK: sw r31, -32768(r16) # encoding: [0x00,0x80,0xf0,0xab]
sw r31, -32768(r16)
# CHECK: sw r10, 32767(r13) # encoding: [0xff,0x7f,0x4d,0xa9]
sw r10, 32767(r13)

# CHECK: swc1 f17, 0(r2) # encoding: [0x00,0x00,0x22,0xae]
swc1 f17, 0(r2)
# CHECK: swc1 f31, -32768(r16) # encoding: [0x00,0x80,0xf0,0xaf]
swc1 f31, -32768(r16)
# CHECK: swc1 f10, 32767(r13) # encoding: [0xff,0x7f,0x4d,0xad]
swc1 f10, 32767(r13)
