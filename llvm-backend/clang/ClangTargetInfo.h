//===- ClangTargetInfo.h - The TP as clang sees it --------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_CLANGTARGETINFO_H
#define TP_LLVM_BACKEND_CLANG_CLANGTARGETINFO_H

#include "clang/Basic/TargetInfo.h"
#include "clang/Basic/TargetOptions.h"
#include "llvm/ADT/IntrusiveRefCntPtr.h"
#include "llvm/IR/DerivedTypes.h"

namespace tp {

/// Sizes of types, predefined macros, builtins, registers and features of the
/// TP. The data layout is llvm::TPDataLayout, the builtins are those of
/// TPBuiltins.def.
class ClangTargetInfo final : public clang::TargetInfo {
public:
  explicit ClangTargetInfo(const llvm::Triple &Triple);

  void getTargetDefines(const clang::LangOptions &Options,
                        clang::MacroBuilder &Builder) const override;
  llvm::SmallVector<clang::Builtin::InfosShard>
  getTargetBuiltins() const override;
  BuiltinVaListKind getBuiltinVaListKind() const override {
    return VoidPtrBuiltinVaList;
  }

  bool isValidCPUName(llvm::StringRef Name) const override;
  void fillValidCPUList(
      llvm::SmallVectorImpl<llvm::StringRef> &Names) const override;
  bool setCPU(const std::string &Name) override;

  bool isValidFeatureName(llvm::StringRef Name) const override;
  bool initFeatureMap(llvm::StringMap<bool> &Features,
                      clang::DiagnosticsEngine &Diags, llvm::StringRef Cpu,
                      const std::vector<std::string> &Changes) const override;
  bool handleTargetFeatures(std::vector<std::string> &Features,
                            clang::DiagnosticsEngine &Diags) override;
  bool hasFeature(llvm::StringRef Name) const override;

  bool validateAsmConstraint(const char *&Name,
                             ConstraintInfo &Info) const override;
  bool validateOutputSize(const llvm::StringMap<bool> &Features,
                          llvm::StringRef Constraint,
                          unsigned Bits) const override;
  bool validateInputSize(const llvm::StringMap<bool> &Features,
                         llvm::StringRef Constraint,
                         unsigned Bits) const override;
  bool validateGlobalRegisterVariable(llvm::StringRef Name, unsigned Bits,
                                      bool &HasSizeMismatch) const override;
  std::string_view getClobbers() const override { return ""; }
  llvm::ArrayRef<const char *> getGCCRegNames() const override;
  llvm::ArrayRef<GCCRegAlias> getGCCRegAliases() const override;

  bool hasInt128Type() const override { return true; }
  bool hasBitIntType() const override { return true; }
  /// Constants of _Float16 are values of the type half, not their bits.
  bool useFP16ConversionIntrinsics() const override { return false; }
  /// Division of more bits than the library's is expanded in line.
  size_t getMaxBitIntWidth() const override {
    return MaxBitIntWidth.value_or(llvm::IntegerType::MAX_INT_BITS);
  }
  bool checkArithmeticFenceSupported() const override { return true; }

private:
  bool HasTrigonometry = true;
  bool HasFusedMultiplyAdd = false;
};

/// Makes the target description that a compilation with \p Options uses;
/// completes the features in \p Options, which must outlive it.
/// \returns null after an error, which has been reported to \p Diags.
llvm::IntrusiveRefCntPtr<ClangTargetInfo>
createClangTargetInfo(clang::DiagnosticsEngine &Diags,
                      clang::TargetOptions &Options);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_CLANGTARGETINFO_H
