# Source lines of an object, also where each function has a section.
# RUN: tp-mc -g -filetype=obj %s -o %t.o
# RUN: tp-objdump -d -l %t.o | FileCheck %s
# RUN: tp-objdump -S %t.o | FileCheck --check-prefix=SOURCE %s
# RUN: tp-objdump -dlS %t.o | FileCheck --check-prefix=BOTH %s

# CHECK: Disassembly of section .text:
# CHECK: ; {{.*}}objdump-lines.s:[[#LINE:]]
# CHECK-NEXT: 0: {{.*}} addi r4, r0, 5
# CHECK-NEXT: ; {{.*}}objdump-lines.s:[[#LINE+1]]
# CHECK-NEXT: 4: {{.*}} lui r4
# CHECK-NEXT: 8: {{.*}} ori r4
# CHECK-NEXT: ; {{.*}}objdump-lines.s:[[#LINE+2]]
# CHECK: Disassembly of section .text.second:
# CHECK: ; {{.*}}objdump-lines.s:[[#LINE+6]]
# CHECK-NEXT: 0: {{.*}} addi r5, r0, 6

# SOURCE-NOT: objdump-lines.s:
# SOURCE: ; addi r4, r0, 5 # five
# SOURCE-NEXT: 0: {{.*}} addi r4, r0, 5
# SOURCE: ; addi r5, r0, 6 # six

# BOTH: objdump-lines.s:[[#]]
# BOTH-NEXT: ; addi r4, r0, 5 # five
.text
first:
addi r4, r0, 5 # five
li r4, 0x12345
ret

.section .text.second,"ax",@progbits
second:
addi r5, r0, 6 # six
ret
