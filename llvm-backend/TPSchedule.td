//===- TPSchedule.td - Functional units and latencies ------*- tablegen -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The units and latency classes serve the code generator's schedule model and
// are the simulator's defaults. How many units of a type a TM has is the chip's
// affair (chip files).
//
//===----------------------------------------------------------------------===//

def TPSchedModel : SchedMachineModel {
  let IssueWidth = 1;
  let MicroOpBufferSize = 0; // in order
  let MispredictPenalty = 0;
  let CompleteModel = 0;
  let PostRAScheduler = 1;
}

// A type of functional unit; the TPs of a TM share its instances.
class TPUnit<string meaning> : ProcResource<1> {
  let BufferSize = 0;
  let SchedModel = TPSchedModel;
  // For the manual.
  string Meaning = meaning;
}

def FPADD : TPUnit<"float add and subtract">;
def FPMIN : TPUnit<"float minimum and maximum">;
def FPCMP : TPUnit<"float compare">;
def FPMUL : TPUnit<"float multiply">;
def FPINV : TPUnit<"reciprocal, square roots, divide, sine and cosine">;
def CONV : TPUnit<"conversions between int and float, rounding">;
def INTADD : TPUnit<"integer add, subtract and compare">;
def INTMUL : TPUnit<"integer multiply">;
def BITWISE : TPUnit<"logic, shifts, moves between registers">;
def BRANCH : TPUnit<"branches, jumps and control">;
def MEMORY : TPUnit<"loads, stores and atomics">;

// When an instruction's result is ready, and what it takes until then.
class TPTime : SchedWrite;

// Takes nothing: no unit, no issue slot, no cycle.
def NoTime : TPTime;
def : WriteRes<NoTime, []> {
  let Latency = 0;
  let NumMicroOps = 0;
  let SchedModel = TPSchedModel;
}

// A latency class: all instructions of one class use the same unit and have
// their result ready `cycles` after issue. A chip file may override it.
class TPLatencyClass<TPUnit unit, int cycles, string source> : TPTime {
  TPUnit Unit = unit;
  int Cycles = cycles;
  // Where the number comes from.
  string Source = source;
}

multiclass TPLatency<TPUnit unit, int cycles, string source> {
  def NAME : TPLatencyClass<unit, cycles, source>;
  def NAME#Resource : WriteRes<!cast<SchedWrite>(NAME), [unit]> {
    let Latency = cycles;
    let SchedModel = TPSchedModel;
  }
}

defvar SimTRaX = "SimTRaX's 65 nm unit table";

defm IntAdd : TPLatency<INTADD, 1, SimTRaX>;
defm IntMul : TPLatency<INTMUL, 1, SimTRaX>;
defm IntDiv : TPLatency<FPINV, 16, "assumption: the divider's line, as for floats">;
defm Bitwise : TPLatency<BITWISE, 1, SimTRaX>;
defm FpAdd : TPLatency<FPADD, 2, SimTRaX>;
defm FpMul : TPLatency<FPMUL, 2, SimTRaX>;
// Its own class because a chip with the instruction has an adder behind its
// multiplier: the sum is ready as late as that of mul_s and add_s in a row.
defm FpMulAdd : TPLatency<FPMUL, 4, "assumption: multiply, then add">;
defm FpMin : TPLatency<FPMIN, 1, SimTRaX>;
defm FpCmp : TPLatency<FPCMP, 1, SimTRaX>;
defm FpInv : TPLatency<FPINV, 16, SimTRaX>;
defm FpTrig : TPLatency<FPINV, 16, "assumption: as the reciprocal">;
defm Convert : TPLatency<CONV, 1, SimTRaX>;
// A taken branch: the next instruction issues this many cycles later.
defm Branch : TPLatency<BRANCH, 1, SimTRaX>;
defm Control : TPLatency<BRANCH, 1, SimTRaX>;
// For the schedule model. In the simulator a load or atomic takes the chip's
// memory latency, or one cycle where the address is in the local store.
defm Load : TPLatency<MEMORY, 100, "SimTRaX's default memory latency">;
defm Atomic : TPLatency<MEMORY, 100, "SimTRaX's default memory latency">;
defm Store : TPLatency<MEMORY, 1, SimTRaX>;
