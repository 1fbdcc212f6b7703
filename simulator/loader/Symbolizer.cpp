//===- Symbolizer.cpp - Source locations of addresses ---------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/loader/Symbolizer.h"

#include "llvm/DebugInfo/DIContext.h"

using namespace llvm;

namespace tp {

static symbolize::LLVMSymbolizer::Options options(SourcePaths Paths) {
  using PathKind = DILineInfoSpecifier::FileLineInfoKind;
  symbolize::LLVMSymbolizer::Options Options;
  switch (Paths) {
  case SourcePaths::AsCompiled:
    Options.PathStyle = PathKind::RawValue;
    break;
  case SourcePaths::Relative:
    Options.PathStyle = PathKind::RelativeFilePath;
    break;
  case SourcePaths::Absolute:
    Options.PathStyle = PathKind::AbsoluteFilePath;
    break;
  }
  return Options;
}

Symbolizer::Symbolizer(const ElfProgram &Program, SourcePaths Paths)
    : Program(Program), Implementation(options(Paths)) {}

std::vector<SourceFrame> Symbolizer::frames(uint32_t Pc) {
  std::vector<SourceFrame> Frames;
  Expected<DIInliningInfo> Info = Implementation.symbolizeInlinedCode(
      Program.object(), {Pc, object::SectionedAddress::UndefSection});
  if (!Info) {
    consumeError(Info.takeError());
    return Frames;
  }
  auto Known = [](const std::string &Text) {
    return Text == DILineInfo::BadString ? std::string() : Text;
  };
  for (uint32_t I = 0; I != Info->getNumberOfFrames(); ++I) {
    const DILineInfo &Line = Info->getFrame(I);
    SourceFrame Frame;
    Frame.Function = Known(Line.FunctionName);
    Frame.File = Known(Line.FileName);
    Frame.Line = Line.Line;
    Frame.Column = Line.Column;
    Frame.FunctionFile = Known(Line.StartFileName);
    Frame.FunctionLine = Line.StartLine;
    if (!Frame.Function.empty() || !Frame.File.empty())
      Frames.push_back(std::move(Frame));
  }
  return Frames;
}

std::string Symbolizer::describe(const SourceFrame &Frame) {
  std::string Text;
  if (!Frame.Function.empty())
    Text += "in " + Frame.Function;
  if (Frame.File.empty() || Frame.Line == 0)
    return Text;
  Text += (Text.empty() ? "at " : " at ") + Frame.File + ":" +
          std::to_string(Frame.Line);
  if (Frame.Column)
    Text += ":" + std::to_string(Frame.Column);
  return Text;
}

} // namespace tp
