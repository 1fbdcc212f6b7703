# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The compilers that are compared, and how each is called."""

import dataclasses
import pathlib

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent

# One meaning of the source for all: what tpcc takes by default is stated for
# the others too. Conversions out of range are undefined, as stock clang has it.
MEANING = ["-fno-math-errno", "-fstrict-float-cast-overflow", "-fsigned-char",
           "-fno-exceptions", "-fno-rtti", "-fno-threadsafe-statics"]
# Nothing in the code but the code.
CODE = ["-fno-pic", "-fomit-frame-pointer", "-fno-stack-protector",
        "-fno-asynchronous-unwind-tables", "-fno-unwind-tables",
        "-ffunction-sections", "-ftls-model=local-exec"]
CONTRACTIONS = {"off": ["-ffp-contract=off"], "stock": ["-ffp-contract=on"]}


@dataclasses.dataclass(frozen=True)
class Target:
    """A compiler with its options, and a disassembler."""

    name: str
    compiler: tuple
    disassembler: tuple

    def compile(self, unit, options, contraction, target_object):
        """The command that compiles the preprocessed text of a unit."""
        return [*self.compiler, *MEANING, *CODE, *CONTRACTIONS[contraction],
                *unit.options, *options, "-w", "-c", "-x", unit.language,
                unit.preprocessed, "-o", target_object]

    def disassemble(self, target_object):
        return [*self.disassembler, "-d", target_object]


def tp(binaries):
    return Target("TP", (binaries / "tpcc", "-fno-lto"),
                  (binaries / "tp-objdump",))


def stock(clang, objdump):
    """Stock clang's other 32-bit targets: processors with floats, and without
    doubles, like the TP."""
    common = ("-fforce-enable-int128", "-include", HERE / "Equivalents.h")
    return [
        Target("riscv32",
               (clang, "--target=riscv32-unknown-elf",
                "-march=rv32imf_zba_zbb", "-mabi=ilp32f", *common),
               (objdump,)),
        Target("mips32r2",
               (clang, "--target=mipsel-unknown-elf", "-march=mips32r2",
                "-msingle-float", "-mno-abicalls", *common),
               (objdump,)),
    ]
