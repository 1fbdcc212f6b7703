//===- RunnerOptions.cpp - Command line of the native runner --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/native/RunnerOptions.h"

#include "tp/memory_map.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <getopt.h>
#include <string_view>
#include <thread>

namespace tp {

std::string runnerUsage(const std::string &Program) {
  return "USAGE: " + Program +
         " [options] [-- kernel arguments]\n\n"
         "Runs a kernel that is compiled for the host.\n\n"
         "OPTIONS:\n"
         "  --threads N          host threads (one per processor)\n"
         "  --local-store BYTES  local store of each thread, as in 16KiB (" +
         std::to_string(host::kDefaultLocalStoreBytes / 1024) +
         "KiB)\n"
         "  --ray-profile        print what the rays visited and read from\n"
         "                       memory\n"
         "  --scene FILE         glTF or GLB file to render (none)\n\n"
         "OPTIONS WITH A SCENE:\n"
         "  --size WIDTHxHEIGHT  size of the picture (256x256)\n"
         "  --spp N              samples per pixel (1)\n"
         "  --depth N            surfaces that a path visits; 1: primary and\n"
         "                       shadow rays (1)\n"
         "  --seed N             seed of the random numbers (1)\n"
         "  --bvh host|kernel    who builds the BVH (host)\n"
         "  --bvh-output FILE    where to write the BVH that the kernel built\n"
         "  -o FILE              PNG to write (none)\n";
}

static Status parseNumber(const char *Option, const char *Text,
                          uint32_t &Number) {
  const char *const End = Text + std::strlen(Text);
  const auto Parsed = std::from_chars(Text, End, Number);
  if (Parsed.ec == std::errc() && Parsed.ptr == End)
    return success();
  return Error{std::string(Option) + ": '" + Text +
               "' is not a whole number below 2^32"};
}

static Status parseLocalStoreBytes(const char *Text, uint32_t &Bytes) {
  constexpr uint32_t Unit = 16;
  const char *const End = Text + std::strlen(Text);
  uint64_t Number = 0;
  const auto Parsed = std::from_chars(Text, End, Number);
  const std::string_view Suffix(Parsed.ptr, End);
  const bool IsNumber = Parsed.ec == std::errc() && Number <= UINT32_MAX;
  if (IsNumber && (Suffix == "KiB" || Suffix == "MiB"))
    Number <<= Suffix == "KiB" ? 10 : 20;
  else if (!IsNumber || !Suffix.empty())
    return Error{"--local-store: '" + std::string(Text) +
                 "' is not a number of bytes, as in 16384 or 16KiB"};
  if (Number > kLocalStoreBytesMax || Number % Unit)
    return Error{"--local-store: must be a multiple of " +
                 std::to_string(Unit) + " up to " +
                 std::to_string(kLocalStoreBytesMax) + " bytes, not " +
                 std::string(Text)};
  Bytes = uint32_t(Number);
  return success();
}

namespace {
/// What getopt_long() returns for an option without a letter.
enum OptionCode {
  SceneCode = 256,
  SizeCode,
  SamplesCode,
  DepthCode,
  SeedCode,
  BvhCode,
  BvhOutputCode,
  ThreadsCode,
  LocalStoreCode,
  RayProfileCode,
  HelpCode
};
} // namespace

/// How an option is spelled that means something with a scene only; nullptr for
/// other options.
static const char *spellingOfSceneOption(int Code) {
  switch (Code) {
  case SizeCode:
    return "--size";
  case SamplesCode:
    return "--spp";
  case DepthCode:
    return "--depth";
  case SeedCode:
    return "--seed";
  case BvhCode:
    return "--bvh";
  case BvhOutputCode:
    return "--bvh-output";
  case 'o':
    return "-o";
  default:
    return nullptr;
  }
}

ErrorOr<RunnerOptions> parseRunnerOptions(int ArgumentCount,
                                          char *const *Arguments) {
  static const option LongOptions[] = {
      {"scene", required_argument, nullptr, SceneCode},
      {"size", required_argument, nullptr, SizeCode},
      {"spp", required_argument, nullptr, SamplesCode},
      {"depth", required_argument, nullptr, DepthCode},
      {"seed", required_argument, nullptr, SeedCode},
      {"bvh", required_argument, nullptr, BvhCode},
      {"bvh-output", required_argument, nullptr, BvhOutputCode},
      {"threads", required_argument, nullptr, ThreadsCode},
      {"local-store", required_argument, nullptr, LocalStoreCode},
      {"ray-profile", no_argument, nullptr, RayProfileCode},
      {"help", no_argument, nullptr, HelpCode},
      {nullptr, 0, nullptr, 0}};
  // What getopt_long() returns for a word that is no option.
  constexpr int PlainWord = 1;
  constexpr unsigned MaxThreads = 1024;
  RunnerOptions Options;
  const char *OptionOfScene = nullptr;
  Options.Threads = std::max(1u, std::thread::hardware_concurrency());
  optind = 1;
  opterr = 0;
  for (;;) {
    Status Parsed = success();
    // The dash keeps the order of the words, so that `--` parts them; the colon
    // tells a missing value from an unknown option.
    const int Code =
        getopt_long(ArgumentCount, Arguments, "-:o:", LongOptions, nullptr);
    if (const char *Spelling = spellingOfSceneOption(Code))
      OptionOfScene = Spelling;
    switch (Code) {
    case SceneCode:
      Options.ScenePath = optarg;
      if (Options.ScenePath.empty())
        Parsed = Error{"--scene: the path is empty"};
      break;
    case SizeCode:
      Parsed = parseImageSize(optarg, Options.Render);
      break;
    case SamplesCode:
      Parsed = parseNumber("--spp", optarg, Options.Render.SamplesPerPixel);
      break;
    case DepthCode:
      Parsed = parseNumber("--depth", optarg, Options.Render.MaxDepth);
      break;
    case SeedCode:
      Parsed = parseNumber("--seed", optarg, Options.Render.Seed);
      break;
    case BvhCode:
      Parsed = parseBvhOrigin(optarg, Options.Render);
      break;
    case BvhOutputCode:
      Options.BvhOutputPath = optarg;
      break;
    case ThreadsCode:
      Parsed = parseNumber("--threads", optarg, Options.Threads);
      if (Parsed && (Options.Threads < 1 || Options.Threads > MaxThreads))
        Parsed = Error{"--threads: must be from 1 to " +
                       std::to_string(MaxThreads) + ", not " + optarg};
      break;
    case LocalStoreCode:
      Parsed = parseLocalStoreBytes(optarg, Options.LocalStoreBytes);
      break;
    case 'o':
      Options.OutputPath = optarg;
      break;
    case RayProfileCode:
      Options.RayProfile = true;
      break;
    case HelpCode:
      Options.Help = true;
      return Options;
    case ':':
      return Error{std::string(Arguments[optind - 1]) + ": needs a value"};
    case '?':
      return Error{std::string("unknown option '") + Arguments[optind - 1] +
                   "'; --help lists the options"};
    case PlainWord:
      return Error{std::string("unexpected argument '") + optarg +
                   "'; arguments of the kernel go behind --"};
    case -1:
      Options.KernelArguments.assign(Arguments + optind,
                                     Arguments + ArgumentCount);
      if (Options.ScenePath.empty() && OptionOfScene)
        return Error{std::string(OptionOfScene) +
                     " has no meaning without --scene; give the scene to "
                     "render"};
      if (!Options.BvhOutputPath.empty() &&
          Options.Render.Bvh != BvhOrigin::Kernel)
        return Error{"--bvh-output has no meaning without --bvh kernel"};
      if (Status Checked = checkRenderOptions(Options.Render); !Checked)
        return Checked.takeError();
      return Options;
    }
    if (!Parsed)
      return Parsed.takeError();
  }
}

} // namespace tp
