//===- TPSubtarget.cpp - One kind of TP -----------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/TPSubtarget.h"
#include "llvm-backend/MCTargetDesc/TPMCTargetDesc.h"
#include "llvm/Analysis/ValueTracking.h"
#include "llvm/CodeGen/LibcallLoweringInfo.h"
#include "llvm/CodeGen/MachineInstr.h"
#include "llvm/CodeGen/MachineMemOperand.h"
#include "llvm/CodeGen/MachineScheduler.h"
#include "llvm/CodeGen/PseudoSourceValue.h"
#include "llvm/CodeGen/ScheduleDAG.h"
#include "llvm/IR/GlobalVariable.h"
#include "llvm/IR/Instructions.h"

using namespace llvm;

#define DEBUG_TYPE "tp-subtarget"

#define GET_SUBTARGETINFO_TARGET_DESC
#define GET_SUBTARGETINFO_CTOR
#include "TPGenSubtargetInfo.inc"

TPSubtarget &TPSubtarget::initialize(StringRef CPU, StringRef FS) {
  ParseSubtargetFeatures(CPU, CPU, FS);
  return *this;
}

TPSubtarget::TPSubtarget(const Triple &TT, StringRef CPU, StringRef FS,
                         const TargetMachine &TM)
    : TPGenSubtargetInfo(TT, CPU, CPU, FS), InstrInfo(initialize(CPU, FS)),
      FrameLowering(*this), Lowering(TM, *this) {}

void TPSubtarget::initLibcallLoweringInfo(LibcallLoweringInfo &Info) const {
  // LLVM gives an architecture that it does not know no library functions. The
  // runtime has those of a bare-metal 32-bit machine with software double.
  static const RTLIB::RuntimeLibcallsInfo Defaults{
      Triple("mipsel-unknown-elf")};
  // The constructor below calls this function.
  static thread_local bool IsNested = false;
  if (IsNested)
    return;
  IsNested = true;
  LibcallLoweringInfo DefaultInfo(Defaults, *this);
  IsNested = false;
  for (RTLIB::Libcall Call : RTLIB::libcalls())
    if (RTLIB::LibcallImpl Impl = DefaultInfo.getLibcallImpl(Call);
        Impl != RTLIB::Unsupported)
      Info.setLibcallImpl(Call, Impl);
  // The runtime's fmin and fmax prefer numbers and order zeros.
  Info.setLibcallImpl(RTLIB::FMINIMUM_NUM_F64, RTLIB::impl_fmin);
  Info.setLibcallImpl(RTLIB::FMAXIMUM_NUM_F64, RTLIB::impl_fmax);
}

void TPSubtarget::overrideSchedPolicy(MachineSchedPolicy &Policy,
                                      const SchedRegion &) const {
  // From the top loads start early, from the bottom few values live at once:
  // the scheduler decides for each instruction.
  Policy.OnlyTopDown = Policy.OnlyBottomUp = false;
}

/// Whether a memory operand is surely in the local store.
static bool isInLocalStore(const MachineMemOperand &Operand) {
  if (const PseudoSourceValue *Pseudo = Operand.getPseudoValue())
    return Pseudo->isStack() || Pseudo->kind() == PseudoSourceValue::FixedStack;
  const Value *Object = Operand.getValue();
  if (!Object)
    return false;
  Object = getUnderlyingObject(Object);
  if (isa<AllocaInst>(Object))
    return true;
  auto *Global = dyn_cast<GlobalVariable>(Object);
  return Global && Global->isThreadLocal();
}

bool TPSubtarget::isGlobalLoad(const MachineInstr &MI) {
  return MI.mayLoad() &&
         (MI.memoperands_empty() ||
          !all_of(MI.memoperands(), [](const MachineMemOperand *Operand) {
            return isInLocalStore(*Operand);
          }));
}

void TPSubtarget::adjustSchedDependency(SUnit *Def, int, SUnit *Use, int,
                                        SDep &Dep,
                                        const TargetSchedModel *) const {
  if (Dep.getKind() != SDep::Data || !Def->isInstr())
    return;
  // It takes the value that is in flight.
  if (Use->isInstr() && Use->getInstr()->getOpcode() == TP::PROFV) {
    Dep.setLatency(0);
    return;
  }
  const MachineInstr &MI = *Def->getInstr();
  if (MI.mayLoad() && !isGlobalLoad(MI))
    Dep.setLatency(1);
}
