//===- ClangTargetInfo.cpp - The TP as clang sees it ----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/ClangTargetInfo.h"
#include "llvm-backend/TPDataLayout.h"
#include "clang/Basic/Builtins.h"
#include "clang/Basic/DiagnosticFrontend.h"
#include "clang/Basic/MacroBuilder.h"
#include "llvm/ADT/StringExtras.h"

using namespace clang;
using namespace llvm;

namespace tp {

static constexpr const char Trigonometry[] = "trig";
static constexpr const char FusedMultiplyAdd[] = "fma";
static constexpr const char GenericCpu[] = "generic";

//===----------------------------------------------------------------------===//
// Builtins
//===----------------------------------------------------------------------===//

namespace {
enum BuiltinNumber {
#define TP_BUILTIN(Name, Type, Attributes, Effect) Builtin_##Name,
#include "llvm-backend/TPBuiltins.def"
  NumBuiltins
};
} // namespace

#define TP_BUILTIN(Name, Type, Attributes, Effect)                             \
  CLANG_BUILTIN_STR_TABLE(__builtin_tp_##Name, Type, Attributes)
static constexpr llvm::StringTable BuiltinStrings =
    CLANG_BUILTIN_STR_TABLE_START
#include "llvm-backend/TPBuiltins.def"
    ;

#define TP_BUILTIN(Name, Type, Attributes, Effect)                             \
  CLANG_BUILTIN_ENTRY(__builtin_tp_##Name, Type, Attributes)
static constexpr auto BuiltinInfos = Builtin::MakeInfos<NumBuiltins>({
#include "llvm-backend/TPBuiltins.def"
});

SmallVector<Builtin::InfosShard> ClangTargetInfo::getTargetBuiltins() const {
  return {{&BuiltinStrings, BuiltinInfos}};
}

//===----------------------------------------------------------------------===//
// Types
//===----------------------------------------------------------------------===//

ClangTargetInfo::ClangTargetInfo(const llvm::Triple &Triple)
    : TargetInfo(Triple) {
  BigEndian = false;
  TLSSupported = true;
  NoAsmVariants = true;
  HasFloat16 = true;
  HasBFloat16 = true;
  // So that clang obeys #pragma float_control. There are no exception flags and
  // no other rounding to be strict about.
  HasStrictFP = true;

  PointerWidth = PointerAlign = 32;
  LongWidth = LongAlign = 32;
  SizeType = UnsignedInt;
  PtrDiffType = SignedInt;
  IntPtrType = SignedInt;
  WCharType = SignedInt;
  WIntType = UnsignedInt;
  Char32Type = UnsignedInt;
  Int64Type = SignedLongLong;
  IntMaxType = SignedLongLong;
  SuitableAlign = 64;
  // As the data layout has it.
  Int128Align = 64;
  BFloat16Width = BFloat16Align = 16;
  BFloat16Format = &llvm::APFloat::BFloat();

  // Wider atomics are calls of the runtime, which takes a lock.
  MaxAtomicInlineWidth = 32;
  MaxAtomicPromoteWidth = 64;

  resetDataLayout(TPDataLayout);
}

void ClangTargetInfo::getTargetDefines(const LangOptions &Options,
                                       MacroBuilder &Builder) const {
  Builder.defineMacro("__tp__");
  Builder.defineMacro("__TP__");
  Builder.defineMacro("__ELF__");
  if (HasTrigonometry)
    Builder.defineMacro("__TP_TRIG__");
  if (HasFusedMultiplyAdd) {
    Builder.defineMacro("__TP_FMA__");
    Builder.defineMacro("__FP_FAST_FMAF");
  }
  for (const char *Width : {"1", "2", "4"})
    Builder.defineMacro(Twine("__GCC_HAVE_SYNC_COMPARE_AND_SWAP_") + Width);
}

//===----------------------------------------------------------------------===//
// Processors and features
//===----------------------------------------------------------------------===//

bool ClangTargetInfo::isValidCPUName(StringRef Name) const {
  return Name == GenericCpu;
}

void ClangTargetInfo::fillValidCPUList(
    SmallVectorImpl<StringRef> &Names) const {
  Names.push_back(GenericCpu);
}

bool ClangTargetInfo::setCPU(const std::string &Name) {
  return isValidCPUName(Name);
}

bool ClangTargetInfo::isValidFeatureName(StringRef Name) const {
  return Name == Trigonometry || Name == FusedMultiplyAdd;
}

bool ClangTargetInfo::initFeatureMap(
    llvm::StringMap<bool> &Features, DiagnosticsEngine &Diags, StringRef Cpu,
    const std::vector<std::string> &Changes) const {
  Features[Trigonometry] = true;
  return TargetInfo::initFeatureMap(Features, Diags, Cpu, Changes);
}

bool ClangTargetInfo::handleTargetFeatures(std::vector<std::string> &Features,
                                           DiagnosticsEngine &Diags) {
  HasTrigonometry =
      llvm::is_contained(Features, std::string("+") + Trigonometry);
  HasFusedMultiplyAdd =
      llvm::is_contained(Features, std::string("+") + FusedMultiplyAdd);
  return true;
}

bool ClangTargetInfo::hasFeature(StringRef Name) const {
  return Name == "tp" || (Name == Trigonometry && HasTrigonometry) ||
         (Name == FusedMultiplyAdd && HasFusedMultiplyAdd);
}

//===----------------------------------------------------------------------===//
// Inline assembly
//===----------------------------------------------------------------------===//

bool ClangTargetInfo::validateAsmConstraint(const char *&Name,
                                            ConstraintInfo &Info) const {
  switch (*Name) {
  case 'f': // A float register.
    Info.setAllowsRegister();
    return true;
  case 's': // The address of a symbol.
    Info.setAllowsRegister();
    return true;
  case 'I': // A signed 16-bit immediate.
    Info.setRequiresImmediate(-32768, 32767);
    return true;
  case 'J': // Zero.
    Info.setRequiresImmediate(0);
    return true;
  case 'K': // An unsigned 16-bit immediate.
    Info.setRequiresImmediate(0, 65535);
    return true;
  }
  return false;
}

/// Whether a value of \p Bits fits the registers of \p Constraint: two of the
/// integer registers, one of the float registers.
static bool fitsConstraint(StringRef Constraint, unsigned Bits) {
  Constraint = Constraint.ltrim("=+&%");
  if (Constraint == "f")
    return Bits <= 32;
  return Constraint != "r" || Bits <= 64;
}

bool ClangTargetInfo::validateOutputSize(const llvm::StringMap<bool> &,
                                         StringRef Constraint,
                                         unsigned Bits) const {
  return fitsConstraint(Constraint, Bits);
}

bool ClangTargetInfo::validateInputSize(const llvm::StringMap<bool> &,
                                        StringRef Constraint,
                                        unsigned Bits) const {
  return fitsConstraint(Constraint, Bits);
}

bool ClangTargetInfo::validateGlobalRegisterVariable(
    StringRef Name, unsigned Bits, bool &HasSizeMismatch) const {
  // Only what no function allocates: zero, the assembler's register and the
  // stack pointer.
  HasSizeMismatch = Bits != 32;
  StringRef Register = getNormalizedGCCRegisterName(Name);
  return Register == "r0" || Register == "r1" || Register == "r29";
}

ArrayRef<const char *> ClangTargetInfo::getGCCRegNames() const {
  static const char *const Names[] = {
      "r0",  "r1",  "r2",  "r3",  "r4",  "r5",  "r6",  "r7",  "r8",  "r9",
      "r10", "r11", "r12", "r13", "r14", "r15", "r16", "r17", "r18", "r19",
      "r20", "r21", "r22", "r23", "r24", "r25", "r26", "r27", "r28", "r29",
      "r30", "r31", "f0",  "f1",  "f2",  "f3",  "f4",  "f5",  "f6",  "f7",
      "f8",  "f9",  "f10", "f11", "f12", "f13", "f14", "f15", "f16", "f17",
      "f18", "f19", "f20", "f21", "f22", "f23", "f24", "f25", "f26", "f27",
      "f28", "f29", "f30", "f31"};
  return Names;
}

ArrayRef<TargetInfo::GCCRegAlias> ClangTargetInfo::getGCCRegAliases() const {
  static const GCCRegAlias Aliases[] = {
      {{"zero"}, "r0"}, {{"sp"}, "r29"}, {{"fp"}, "r30"}, {{"ra"}, "r31"}};
  return Aliases;
}

//===----------------------------------------------------------------------===//
// Creation
//===----------------------------------------------------------------------===//

namespace {
// clang::TargetInfo::TargetOpts is private and only set by
// TargetInfo::CreateTargetInfo, which knows the targets in clang's tree only.
// The names in an explicit instantiation are not access-checked, so a friend
// that one defines can hand the member out.
clang::TargetOptions *&targetOptionsOf(clang::TargetInfo &Target);

template <clang::TargetOptions *clang::TargetInfo::*Member>
struct TargetOptionsAccess {
  // NOLINTNEXTLINE(llvm-prefer-static-over-anonymous-namespace): a friend.
  friend clang::TargetOptions *&targetOptionsOf(clang::TargetInfo &Target) {
    return Target.*Member;
  }
};
template struct TargetOptionsAccess<&clang::TargetInfo::TargetOpts>;
} // namespace

IntrusiveRefCntPtr<ClangTargetInfo>
createClangTargetInfo(DiagnosticsEngine &Diags, clang::TargetOptions &Options) {
  auto Target =
      llvm::makeIntrusiveRefCnt<ClangTargetInfo>(llvm::Triple(Options.Triple));
  targetOptionsOf(*Target) = &Options;

  if (Options.CPU.empty())
    Options.CPU = GenericCpu;
  if (!Target->setCPU(Options.CPU)) {
    Diags.Report(diag::err_target_unknown_cpu) << Options.CPU;
    SmallVector<StringRef> Names;
    Target->fillValidCPUList(Names);
    Diags.Report(diag::note_valid_options) << llvm::join(Names, ", ");
    return nullptr;
  }
  if (!Target->initFeatureMap(Options.FeatureMap, Diags, Options.CPU,
                              Options.FeaturesAsWritten))
    return nullptr;
  Options.Features.clear();
  for (const auto &Feature : Options.FeatureMap)
    Options.Features.push_back(
        (Twine(Feature.second ? "+" : "-") + Feature.first()).str());
  llvm::sort(Options.Features);
  if (!Target->handleTargetFeatures(Options.Features, Diags))
    return nullptr;
  Target->setMaxAtomicWidth();
  return Target;
}

} // namespace tp
