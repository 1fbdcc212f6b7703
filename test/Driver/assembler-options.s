# What clang's driver hands to the assembler.
#
# RUN: tpcc -c -g -gz %s -o %t.o && llvm-readelf -S %t.o | FileCheck --check-prefix=COMPRESSED %s
# RUN: tpcc -c -g -Wa,--compress-debug-sections %s -o %t.o && llvm-readelf -S %t.o | FileCheck --check-prefix=COMPRESSED %s
# RUN: tpcc -c -g %s -o %t.o && llvm-readelf -S %t.o | FileCheck --check-prefix=PLAIN %s
# RUN: tpcc -c -g -gz %s -o %t.o && tpcc -nostdlib %t.o -o %t.elf && llvm-dwarfdump --debug-line %t.elf | FileCheck --check-prefix=LINES %s
# RUN: tpcc -c -g -gdwarf-4 %s -o %t.o && llvm-dwarfdump --debug-info %t.o | FileCheck --check-prefix=DWARF4 %s
# RUN: tpcc -c -Wa,--defsym,ANSWER=42 %s -o %t.o && llvm-nm %t.o | FileCheck --check-prefix=DEFINED %s
# RUN: tpcc -c -Wa,-L %s -o %t.o && llvm-nm %t.o | FileCheck --check-prefix=LOCAL %s
# RUN: not tpcc -c -Wa,--fatal-warnings -Wa,--defsym,WARN=1 %s -o %t.o 2>&1 | FileCheck --check-prefix=FATAL %s
# RUN: tpcc -c -Wa,--no-warn -Wa,--defsym,WARN=1 %s -o %t.o 2>&1 | count 0
# RUN: not tpcc -c -Wa,-nonsense %s -o %t.o 2>&1 | FileCheck --check-prefix=UNKNOWN %s
# RUN: not tpcc -c -Wa,--defsym,ANSWER=many %s -o %t.o 2>&1 | FileCheck --check-prefix=VALUE %s

# COMPRESSED: .debug_line PROGBITS {{[0-9a-f ]+}} C
# PLAIN-NOT: .debug_line PROGBITS {{[0-9a-f ]+}} C
# LINES: assembler-options.s
# DWARF4: version = 0x0004
# DEFINED: 0000002a {{.}} ANSWER
# LOCAL: .Llocal
# FATAL: assembler-options.s:[[@LINE+5]]:{{[0-9]+}}: error: careful
# UNKNOWN: tpcc: error: unsupported argument '-nonsense' to option '-Wa,'
# VALUE: tpcc: error: {{.*}}many

.ifdef WARN
.warning "careful"
.endif
  .globl _start
_start:
.Llocal:
  .rept 400
  addi r2, r2, 1
  .endr
  halt r2
