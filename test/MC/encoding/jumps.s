# Jumps; the target is the distance in bytes, encoded in words.
# The expected bytes were worked out by hand from the format:
# J: opcode 31-26, target 25-0
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

# CHECK: j -134217728 # encoding: [0x00,0x00,0x00,0xe2]
j -134217728
# CHECK: j 134217724 # encoding: [0xff,0xff,0xff,0xe1]
j 134217724
# CHECK: j -8 # encoding: [0xfe,0xff,0xff,0xe3]
j -8
# CHECK: j 0 # encoding: [0x00,0x00,0x00,0xe0]
j 0

# CHECK: jal -134217728 # encoding: [0x00,0x00,0x00,0xe6]
jal -134217728
# CHECK: jal 134217724 # encoding: [0xff,0xff,0xff,0xe5]
jal 134217724
# CHECK: jal -8 # encoding: [0xfe,0xff,0xff,0xe7]
jal -8
# CHECK: jal 0 # encoding: [0x00,0x00,0x00,0xe4]
jal 0
