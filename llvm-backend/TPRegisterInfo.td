//===- TPRegisterInfo.td - The TP's registers --------------*- tablegen -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

class TPReg<bits<5> number, string name, list<string> altNames = []>
    : Register<name, altNames> {
  let HWEncoding{4-0} = number;
  let Namespace = "TP";
}

// r0 reads as zero and ignores writes.
def R0 : TPReg<0, "r0", ["zero"]>, DwarfRegNum<[0]> { let isConstant = true; }
foreach i = 1-28 in
  def R#i : TPReg<i, "r"#i>, DwarfRegNum<[i]>;
def R29 : TPReg<29, "r29", ["sp"]>, DwarfRegNum<[29]>;
def R30 : TPReg<30, "r30", ["fp"]>, DwarfRegNum<[30]>;
def R31 : TPReg<31, "r31", ["ra"]>, DwarfRegNum<[31]>;

foreach i = 0-31 in
  def F#i : TPReg<i, "f"#i>, DwarfRegNum<[!add(i, 32)]>;

// Allocation order: temporaries, arguments from the last to the first, results,
// then what a function has to save. r0, r1 (scratch of the code generator) and
// r29 (stack pointer) are reserved.
def GPR : RegisterClass<"TP", [i32], 32,
                        (add (sequence "R%u", 12, 15), (sequence "R%u", 24, 28),
                             (sequence "R%u", 11, 4), R3, R2,
                             (sequence "R%u", 16, 23), R31, R30, R29, R1, R0)> {
  let DiagnosticString = "operand must be an integer register (r0 to r31)";
}

// Where the target of an indirect tail call can be: what no function saves.
def GPRTail : RegisterClass<"TP", [i32], 32,
                            (add (sequence "R%u", 12, 15),
                                 (sequence "R%u", 24, 28),
                                 (sequence "R%u", 11, 4), R3, R2)>;

def FPR : RegisterClass<"TP", [f32], 32,
                        (add (sequence "F%u", 12, 19), (sequence "F%u", 11, 4),
                             (sequence "F%u", 3, 0), (sequence "F%u", 20, 31))> {
  let DiagnosticString = "operand must be a float register (f0 to f31)";
}

// For what comes from global memory: the same registers, dearer to spill
// (TPGlobalLoads.cpp).
def GPRLoaded : RegisterClass<"TP", [i32], 32, (add GPR)> {
  let DiagnosticString = GPR.DiagnosticString;
}
def FPRLoaded : RegisterClass<"TP", [f32], 32, (add FPR)> {
  let DiagnosticString = FPR.DiagnosticString;
}

//===----------------------------------------------------------------------===//
// Special registers, read by `mfsr`
//===----------------------------------------------------------------------===//

include "llvm/TableGen/SearchableTable.td"

class TPSpecialRegister<bits<5> encoding, string name, string meaning> {
  bits<5> Encoding = encoding;
  string Name = name;
  // For the manual.
  string Meaning = meaning;
}

def SpecialRegisterEncoding : GenericEnum {
  let FilterClass = "TPSpecialRegister";
  let NameField = "Name";
  let ValueField = "Encoding";
}
def SpecialRegisters : GenericTable {
  let FilterClass = "TPSpecialRegister";
  let CppTypeName = "SpecialRegister";
  let Fields = ["Encoding", "Name"];
  let PrimaryKey = ["Encoding"];
  let PrimaryKeyName = "lookupByEncoding";
}
def lookupByName : SearchIndex {
  let Table = SpecialRegisters;
  let Key = ["Name"];
}

def : TPSpecialRegister<0, "thread", "number of this thread in the chip: tm x ntp + tp">;
def : TPSpecialRegister<1, "tp", "number of this TP in its TM">;
def : TPSpecialRegister<2, "tm", "number of this TM in the chip">;
def : TPSpecialRegister<3, "nthread", "threads of the chip">;
def : TPSpecialRegister<4, "ntp", "TPs of each TM">;
def : TPSpecialRegister<5, "ntm", "TMs of the chip">;
def : TPSpecialRegister<6, "lssize", "bytes of this TP's local store">;
def : TPSpecialRegister<7, "cycle", "cycles since the start, low word">;
def : TPSpecialRegister<8, "cycleh", "cycles since the start, high word">;
def : TPSpecialRegister<9, "instret", "instructions issued by this thread before this one, low word">;
def : TPSpecialRegister<10, "instreth", "instructions issued by this thread before this one, high word">;
