# A frame starts with the caller's stack pointer as its address.
# RUN: tp-mc -filetype=obj %s -o %t.o
# RUN: llvm-dwarfdump --debug-frame %t.o 2>&1 | FileCheck %s
# RUN: llvm-readelf -S -s %t.o | FileCheck --check-prefix=ELF %s

# CHECK: Code alignment factor: 4
# CHECK: Data alignment factor: -4
# CHECK: Return address column: 31
# CHECK: DW_CFA_def_cfa: reg29 +0
# CHECK: DW_CFA_advance_loc: 4
# CHECK: DW_CFA_def_cfa_offset: +16
# CHECK: DW_CFA_offset: reg31 -4
# CHECK: DW_CFA_offset: reg52 -8
# ELF: .debug_frame
# ELF: 16 FUNC GLOBAL DEFAULT {{.*}} function
.cfi_sections .debug_frame
.globl function
.type function, @function
function:
.cfi_startproc
addi sp, sp, -16
.cfi_def_cfa_offset 16
sw ra, 12(sp)
swc1 f20, 8(sp)
.cfi_offset ra, -4
.cfi_offset f20, -8
ret
.cfi_endproc
.size function, . - function
