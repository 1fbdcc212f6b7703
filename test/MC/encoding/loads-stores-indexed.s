# Loads and stores with an index: rt(rs), c = rt.
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

# CHECK: lbx r17, r31(r2) # encoding: [0x00,0xf8,0x22,0x0a]
lbx r17, r31(r2)
# CHECK: lbx r31, r1(r16) # encoding: [0x00,0x08,0xf0,0x0b]
lbx r31, r1(r16)
# CHECK: lbx r10, r4(r13) # encoding: [0x00,0x20,0x4d,0x09]
lbx r10, r4(r13)

# CHECK: lbux r17, r31(r2) # encoding: [0x01,0xf8,0x22,0x0a]
lbux r17, r31(r2)
# CHECK: lbux r31, r1(r16) # encoding: [0x01,0x08,0xf0,0x0b]
lbux r31, r1(r16)
# CHECK: lbux r10, r4(r13) # encoding: [0x01,0x20,0x4d,0x09]
lbux r10, r4(r13)

# CHECK: lhx r17, r31(r2) # encoding: [0x02,0xf8,0x22,0x0a]
lhx r17, r31(r2)
# CHECK: lhx r31, r1(r16) # encoding: [0x02,0x08,0xf0,0x0b]
lhx r31, r1(r16)
# CHECK: lhx r10, r4(r13) # encoding: [0x02,0x20,0x4d,0x09]
lhx r10, r4(r13)

# CHECK: lhux r17, r31(r2) # encoding: [0x03,0xf8,0x22,0x0a]
lhux r17, r31(r2)
# CHECK: lhux r31, r1(r16) # encoding: [0x03,0x08,0xf0,0x0b]
lhux r31, r1(r16)
# CHECK: lhux r10, r4(r13) # encoding: [0x03,0x20,0x4d,0x09]
lhux r10, r4(r13)

# CHECK: lwx r17, r31(r2) # encoding: [0x04,0xf8,0x22,0x0a]
lwx r17, r31(r2)
# CHECK: lwx r31, r1(r16) # encoding: [0x04,0x08,0xf0,0x0b]
lwx r31, r1(r16)
# CHECK: lwx r10, r4(r13) # encoding: [0x04,0x20,0x4d,0x09]
lwx r10, r4(r13)

# CHECK: lwxc1 f17, r31(r2) # encoding: [0x05,0xf8,0x22,0x0a]
lwxc1 f17, r31(r2)
# CHECK: lwxc1 f31, r1(r16) # encoding: [0x05,0x08,0xf0,0x0b]
lwxc1 f31, r1(r16)
# CHECK: lwxc1 f10, r4(r13) # encoding: [0x05,0x20,0x4d,0x09]
lwxc1 f10, r4(r13)

# CHECK: sbx r17, r31(r2) # encoding: [0x08,0xf8,0x22,0x0a]
sbx r17, r31(r2)
# CHECK: sbx r31, r1(r16) # encoding: [0x08,0x08,0xf0,0x0b]
sbx r31, r1(r16)
# CHECK: sbx r10, r4(r13) # encoding: [0x08,0x20,0x4d,0x09]
sbx r10, r4(r13)

# CHECK: shx r17, r31(r2) # encoding: [0x09,0xf8,0x22,0x0a]
shx r17, r31(r2)
# CHECK: shx r31, r1(r16) # encoding: [0x09,0x08,0xf0,0x0b]
shx r31, r1(r16)
# CHECK: shx r10, r4(r13) # encoding: [0x09,0x20,0x4d,0x09]
shx r10, r4(r13)

# CHECK: swx r17, r31(r2) # encoding: [0x0a,0xf8,0x22,0x0a]
swx r17, r31(r2)
# CHECK: swx r31, r1(r16) # encoding: [0x0a,0x08,0xf0,0x0b]
swx r31, r1(r16)
# CHECK: swx r10, r4(r13) # encoding: [0x0a,0x20,0x4d,0x09]
swx r10, r4(r13)

# CHECK: swxc1 f17, r31(r2) # encoding: [0x0b,0xf8,0x22,0x0a]
swxc1 f17, r31(r2)
# CHECK: swxc1 f31, r1(r16) # encoding: [0x0b,0x08,0xf0,0x0b]
swxc1 f31, r1(r16)
# CHECK: swxc1 f10, r4(r13) # encoding: [0x0b,0x20,0x4d,0x09]
swxc1 f10, r4(r13)
