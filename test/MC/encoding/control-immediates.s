# Control with a number.
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

# CHECK: break 0 # encoding: [0x00,0x00,0x00,0xe8]
break 0
# CHECK: break 65535 # encoding: [0xff,0xff,0x00,0xe8]
break 65535
# CHECK: break 4660 # encoding: [0x34,0x12,0x00,0xe8]
break 4660

# CHECK: prof 0 # encoding: [0x00,0x00,0x00,0xec]
prof 0
# CHECK: prof 65535 # encoding: [0xff,0xff,0x00,0xec]
prof 65535
# CHECK: prof 4660 # encoding: [0x34,0x12,0x00,0xec]
prof 4660

# CHECK: profv 0, r0 # encoding: [0x00,0x00,0x00,0xf4]
profv 0, r0
# CHECK: profv 65535, r31 # encoding: [0xff,0xff,0x1f,0xf4]
profv 65535, r31
# CHECK: profv 4660, r10 # encoding: [0x34,0x12,0x0a,0xf4]
profv 4660, r10

# CHECK: hostcall 0 # encoding: [0x00,0x00,0x00,0xf0]
hostcall 0
# CHECK: hostcall 65535 # encoding: [0xff,0xff,0x00,0xf0]
hostcall 65535
# CHECK: hostcall 4660 # encoding: [0x34,0x12,0x00,0xf0]
hostcall 4660
