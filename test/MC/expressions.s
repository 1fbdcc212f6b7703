# Halves of addresses, and operands that are known after layout.
# RUN: tp-mc -filetype=obj %s -o %t.o
# RUN: tp-objdump -d %t.o | FileCheck %s
# RUN: tp-mc %s | FileCheck --check-prefix=TEXT %s

# %hi takes the carry that the sign-extended %lo takes away.
# CHECK: lui r4, 4660
# CHECK-NEXT: addi r4, r4, 32767
# TEXT: lui r4, %hi(305430527)
lui r4, %hi(0x12347fff)
addi r4, r4, %lo(0x12347fff)
# CHECK-NEXT: lui r4, 4661
# CHECK-NEXT: addi r4, r4, -32768
lui r4, %hi(0x12348000)
addi r4, r4, %lo(0x12348000)
# CHECK-NEXT: lui r4, 0
# CHECK-NEXT: lw r4, -4(r4)
lui r4, %hi(0xfffffffc)
lw r4, %lo(0xfffffffc)(r4)

# A relocated half keeps the whole value in the addend.
# CHECK-NEXT: lui r5, %hi(symbol+98304)
# CHECK-NEXT: swc1 f3, %lo(symbol-4)(r5)
lui r5, %hi(symbol + 0x18000)
swc1 f3, %lo(symbol - 4)(r5)

# Constants after layout.
# CHECK-NEXT: addi r6, r0, 12
# CHECK: ori r6, r0, 12
# CHECK-NEXT: addi r6, r0, -4
addi r6, r0, end - begin
begin:
ori r6, r0, end - .
addi r6, r0, begin - end + 8
nop
end:
# CHECK: addi r6, r0, 42
.set answer, 42
addi r6, r0, answer

# Targets: symbols, also ones with the name of a register, and distances.
# CHECK: beq r4, r5, 0x{{[0-9a-f]+}} <end
# CHECK-NEXT: jal f1
# CHECK-NEXT: j sp+4
# CHECK-NEXT: lui r4, %hi(ra)
# CHECK-NEXT: addi r4, r4, %lo(ra)
# TEXT: beq r4, r5, end
# TEXT: jal f1
beq r4, r5, end
jal f1
j sp + 4
la r4, ra
# CHECK-NEXT: [[#%x,HERE:]]: {{[0-9a-f]+}} bne r4, r5
# CHECK-SAME: 0x[[#HERE+8]] <end
bne r4, r5, . + 8
nop
