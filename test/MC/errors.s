# What is wrong is named, with its place and what is allowed.
# RUN: not tp-mc -filetype=null %s 2>&1 | FileCheck --implicit-check-not=error: %s

# CHECK: :[[@LINE+1]]:14: error: immediate must be an integer in the range [-32768, 32767] or %lo(symbol)
addi r4, r5, 32768
# CHECK: :[[@LINE+1]]:14: error: immediate must be an integer in the range [-32768, 32767]
addi r4, r5, -32769
# CHECK: :[[@LINE+1]]:14: error: immediate must be an integer in the range [0, 65535] or %hi(symbol)
andi r4, r5, -1
# CHECK: :[[@LINE+1]]:9: error: immediate must be an integer in the range [0, 65535]
lui r4, 65536
# CHECK: :[[@LINE+1]]:14: error: immediate must be an integer in the range [-32768, 32767] or %lo(symbol)
addi r4, r5, %hi(symbol)
# CHECK: :[[@LINE+1]]:9: error: immediate must be an integer in the range [0, 65535] or %hi(symbol)
lui r4, %lo(symbol)
# CHECK: :[[@LINE+1]]:14: error: immediate must be an integer in the range [-32768, 32767]
addi r4, r5, 1.5
# CHECK: :[[@LINE+1]]:13: error: immediate must be an integer in the range [0, 31]
sll r4, r5, 32
# CHECK: :[[@LINE+1]]:13: error: immediate must be an integer in the range [0, 31]
sll r4, r5, symbol
# CHECK: :[[@LINE+1]]:7: error: immediate must be an integer in the range [0, 65535]
break 65536
# CHECK: :[[@LINE+1]]:8: error: immediate must be an integer in the range [-32768, 32767]
lw r4, 32768(r5)
# CHECK: :[[@LINE+1]]:8: error: immediate must be an integer in the range [-2147483648, 4294967295]
li r4, 0x100000000
# CHECK: :[[@LINE+1]]:8: error: immediate must be an integer in the range [-2147483648, 4294967295]
li r4, symbol

# CHECK: :[[@LINE+1]]:9: error: operand must be an integer register (r0 to r31)
add r4, f5, r6
# CHECK: :[[@LINE+1]]:9: error: operand must be an integer register (r0 to r31)
add r4, 5, r6
# CHECK: :[[@LINE+1]]:9: error: operand must be an integer register (r0 to r31)
add r4, r32, r6
# CHECK: :[[@LINE+1]]:7: error: operand must be a float register (f0 to f31)
add_s r4, f5, f6
# CHECK: :[[@LINE+1]]:10: error: operand must be an integer register (r0 to r31)
lw r4, 4(f5)
# CHECK: :[[@LINE+1]]:10: error: there is no special register 'clock'
mfsr r4, clock
# CHECK: :[[@LINE+1]]:10: error: operand must be a special register
mfsr r4, 11

# CHECK: :[[@LINE+1]]:13: error: branch target must be a symbol or a multiple of 4 in the range [-131072, 131068]
beq r4, r5, 2
# CHECK: :[[@LINE+1]]:13: error: branch target must be a symbol or a multiple of 4 in the range [-131072, 131068]
beq r4, r5, 131072
# CHECK: :[[@LINE+1]]:13: error: branch target must be a symbol or a multiple of 4 in the range [-131072, 131068]
beq r4, r5, -131076
# CHECK: :[[@LINE+1]]:3: error: jump target must be a symbol or a multiple of 4 in the range [-134217728, 134217724]
j 134217728
# CHECK: :[[@LINE+1]]:5: error: jump target must be a symbol or a multiple of 4 in the range [-134217728, 134217724]
jal (r4)

# CHECK: :[[@LINE+1]]:13: error: lowest bit of the field is above its highest bit
ext r4, r5, 8, 7
# CHECK: :[[@LINE+1]]:13: error: lowest bit of the field is above its highest bit
ins r4, r5, 31, 0

# CHECK: :[[@LINE+1]]:1: error: unknown instruction 'adds', did you mean: add, add_s, addc, addi
adds r4, r5, r6
# CHECK: :[[@LINE+1]]:1: error: unknown instruction 'frobnicate'{{$}}
frobnicate r4
# CHECK: :[[@LINE+1]]:1: error: too few operands for instruction 'add'
add r4, r5
# CHECK: :[[@LINE+1]]:1: error: too few operands for instruction 'jr'
jr
# CHECK: :[[@LINE+1]]:17: error: too many operands for instruction 'add'
add r4, r5, r6, r7
# CHECK: :[[@LINE+1]]:5: error: too many operands for instruction 'nop'
nop r4
# CHECK: :[[@LINE+1]]:18: error: too many operands for instruction 'addi'
addi r4, r5, 6(r7)
# CHECK: :[[@LINE+1]]:11: error: expected '(' and a base register
lw r4, 4, r5
# CHECK: :[[@LINE+1]]:18: error: expected '(' and a base register
atom_add r4, r5, r6
# CHECK: :[[@LINE+1]]:12: error: expected ')' after the base register
lw r4, 4(r5
# CHECK: :[[@LINE+1]]:14: error: expected %hi or %lo
addi r4, r5, %half(symbol)
# CHECK: :[[@LINE+1]]:18: error: expected '(' after %hi or %lo
addi r4, r5, %lo symbol
# CHECK: :[[@LINE+1]]:8: error: expected newline
add r4 r5 r6
# CHECK: :[[@LINE+1]]:8: error: unknown token in expression
add r4,,r6
# CHECK: :[[@LINE+1]]:1: error: unknown directive
.nosuchdirective
