# Float compares.
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

# CHECK: c_un_s r17, f2, f31 # encoding: [0x20,0xf8,0x22,0x06]
c_un_s r17, f2, f31
# CHECK: c_un_s r31, f16, f1 # encoding: [0x20,0x08,0xf0,0x07]
c_un_s r31, f16, f1
# CHECK: c_un_s r10, f13, f4 # encoding: [0x20,0x20,0x4d,0x05]
c_un_s r10, f13, f4

# CHECK: c_or_s r17, f2, f31 # encoding: [0x21,0xf8,0x22,0x06]
c_or_s r17, f2, f31
# CHECK: c_or_s r31, f16, f1 # encoding: [0x21,0x08,0xf0,0x07]
c_or_s r31, f16, f1
# CHECK: c_or_s r10, f13, f4 # encoding: [0x21,0x20,0x4d,0x05]
c_or_s r10, f13, f4

# CHECK: c_eq_s r17, f2, f31 # encoding: [0x22,0xf8,0x22,0x06]
c_eq_s r17, f2, f31
# CHECK: c_eq_s r31, f16, f1 # encoding: [0x22,0x08,0xf0,0x07]
c_eq_s r31, f16, f1
# CHECK: c_eq_s r10, f13, f4 # encoding: [0x22,0x20,0x4d,0x05]
c_eq_s r10, f13, f4

# CHECK: c_une_s r17, f2, f31 # encoding: [0x23,0xf8,0x22,0x06]
c_une_s r17, f2, f31
# CHECK: c_une_s r31, f16, f1 # encoding: [0x23,0x08,0xf0,0x07]
c_une_s r31, f16, f1
# CHECK: c_une_s r10, f13, f4 # encoding: [0x23,0x20,0x4d,0x05]
c_une_s r10, f13, f4

# CHECK: c_ueq_s r17, f2, f31 # encoding: [0x24,0xf8,0x22,0x06]
c_ueq_s r17, f2, f31
# CHECK: c_ueq_s r31, f16, f1 # encoding: [0x24,0x08,0xf0,0x07]
c_ueq_s r31, f16, f1
# CHECK: c_ueq_s r10, f13, f4 # encoding: [0x24,0x20,0x4d,0x05]
c_ueq_s r10, f13, f4

# CHECK: c_one_s r17, f2, f31 # encoding: [0x25,0xf8,0x22,0x06]
c_one_s r17, f2, f31
# CHECK: c_one_s r31, f16, f1 # encoding: [0x25,0x08,0xf0,0x07]
c_one_s r31, f16, f1
# CHECK: c_one_s r10, f13, f4 # encoding: [0x25,0x20,0x4d,0x05]
c_one_s r10, f13, f4

# CHECK: c_olt_s r17, f2, f31 # encoding: [0x26,0xf8,0x22,0x06]
c_olt_s r17, f2, f31
# CHECK: c_olt_s r31, f16, f1 # encoding: [0x26,0x08,0xf0,0x07]
c_olt_s r31, f16, f1
# CHECK: c_olt_s r10, f13, f4 # encoding: [0x26,0x20,0x4d,0x05]
c_olt_s r10, f13, f4

# CHECK: c_ole_s r17, f2, f31 # encoding: [0x27,0xf8,0x22,0x06]
c_ole_s r17, f2, f31
# CHECK: c_ole_s r31, f16, f1 # encoding: [0x27,0x08,0xf0,0x07]
c_ole_s r31, f16, f1
# CHECK: c_ole_s r10, f13, f4 # encoding: [0x27,0x20,0x4d,0x05]
c_ole_s r10, f13, f4

# CHECK: c_ult_s r17, f2, f31 # encoding: [0x28,0xf8,0x22,0x06]
c_ult_s r17, f2, f31
# CHECK: c_ult_s r31, f16, f1 # encoding: [0x28,0x08,0xf0,0x07]
c_ult_s r31, f16, f1
# CHECK: c_ult_s r10, f13, f4 # encoding: [0x28,0x20,0x4d,0x05]
c_ult_s r10, f13, f4

# CHECK: c_ule_s r17, f2, f31 # encoding: [0x29,0xf8,0x22,0x06]
c_ule_s r17, f2, f31
# CHECK: c_ule_s r31, f16, f1 # encoding: [0x29,0x08,0xf0,0x07]
c_ule_s r31, f16, f1
# CHECK: c_ule_s r10, f13, f4 # encoding: [0x29,0x20,0x4d,0x05]
c_ule_s r10, f13, f4
