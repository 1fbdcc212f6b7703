# Aliases and macros, and the instructions that they stand for.
#
# RUN: tp-mc -no-aliases %s | FileCheck %s
# RUN: tp-mc %s | FileCheck --check-prefix=ALIAS %s

# CHECK: addi r0, r0, 0
# ALIAS: {{^}} nop
nop
# CHECK-NEXT: addi r4, r5, 0
# ALIAS-NEXT: move r4, r5
move r4, r5
# CHECK-NEXT: nor r4, r5, r0
# ALIAS-NEXT: not r4, r5
not r4, r5
# CHECK-NEXT: sub r4, r0, r5
# ALIAS-NEXT: neg r4, r5
neg r4, r5
# CHECK-NEXT: beq r4, r0, 8
# ALIAS-NEXT: beq r4, r0, 8
beqz r4, 8
# CHECK-NEXT: bne r4, r0, target
# ALIAS-NEXT: bne r4, r0, target
bnez r4, target
# CHECK-NEXT: jr r31
# ALIAS-NEXT: ret
ret

# Loads and stores without an offset.
# CHECK: lb r4, 0(r5)
# ALIAS: lb r4, 0(r5)
lb r4, (r5)
# CHECK-NEXT: lbu r4, 0(r5)
lbu r4, (r5)
# CHECK-NEXT: lh r4, 0(r5)
lh r4, (r5)
# CHECK-NEXT: lhu r4, 0(r5)
lhu r4, (r5)
# CHECK-NEXT: lw r4, 0(r5)
lw r4, (r5)
# CHECK-NEXT: lwc1 f4, 0(r5)
lwc1 f4, (r5)
# CHECK-NEXT: sb r4, 0(r5)
sb r4, (r5)
# CHECK-NEXT: sh r4, 0(r5)
sh r4, (r5)
# CHECK-NEXT: sw r4, 0(r5)
sw r4, (r5)
# CHECK-NEXT: swc1 f4, 0(r5)
swc1 f4, (r5)

# The shortest sequence for each constant.
# CHECK: addi r4, r0, 0
li r4, 0
# CHECK-NEXT: addi r4, r0, 32767
li r4, 32767
# CHECK-NEXT: addi r4, r0, -32768
li r4, -32768
# CHECK-NEXT: addi r4, r0, -1
li r4, 0xffffffff
# CHECK-NEXT: addi r4, r0, -32768
li r4, 0xffff8000
# CHECK-NEXT: ori r4, r0, 32768
li r4, 32768
# CHECK-NEXT: ori r4, r0, 65535
li r4, 65535
# CHECK-NEXT: lui r4, 1
li r4, 65536
# CHECK-NEXT: lui r4, 32768
li r4, -2147483648
# CHECK-NEXT: lui r4, 65535
# CHECK-NEXT: ori r4, r4, 32767
li r4, -32769
# CHECK-NEXT: lui r4, 4660
# CHECK-NEXT: ori r4, r4, 22136
li r4, 0x12345678
# CHECK-NEXT: addi r4, r0, 12
li r4, (1 + 2) * 4

# CHECK: lui r4, %hi(symbol+4)
# CHECK-NEXT: addi r4, r4, %lo(symbol+4)
la r4, symbol + 4
# CHECK-NEXT: lui r4, 1
la r4, 0x10000

# Registers by their other names.
# CHECK: add r0, r29, r30
add zero, sp, fp
# CHECK-NEXT: jr r31
jr ra
