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
         " --scene FILE [options] [-- kernel arguments]\n\n"
         "Renders a scene with a kernel that is compiled for the host.\n\n"
         "OPTIONS:\n"
         "  --scene FILE         glTF or GLB file to render\n"
         "  --size WIDTHxHEIGHT  size of the picture (256x256)\n"
         "  --spp N              samples per pixel (1)\n"
         "  --depth N            surfaces that a path visits; 1: primary and\n"
         "                       shadow rays (1)\n"
         "  --seed N             seed of the random numbers (1)\n"
         "  --bvh host|kernel    who builds the BVH (host)\n"
         "  --bvh-output FILE    where to write the BVH that the kernel built\n"
         "  --threads N          host threads (one per processor)\n"
         "  --local-store BYTES  local store of each thread, as in 16KiB (" +
         std::to_string(host::kDefaultLocalStoreBytes / 1024) +
         "KiB)\n"
         "  --ray-profile        print what the rays visited and read from\n"
         "                       memory\n"
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

ErrorOr<RunnerOptions> parseRunnerOptions(int ArgumentCount,
                                          char *const *Arguments) {
  enum {
    Scene = 256,
    Size,
    Samples,
    Depth,
    Seed,
    Bvh,
    BvhOutput,
    Threads,
    LocalStore,
    RayProfile,
    Help
  };
  static const option LongOptions[] = {
      {"scene", required_argument, nullptr, Scene},
      {"size", required_argument, nullptr, Size},
      {"spp", required_argument, nullptr, Samples},
      {"depth", required_argument, nullptr, Depth},
      {"seed", required_argument, nullptr, Seed},
      {"bvh", required_argument, nullptr, Bvh},
      {"bvh-output", required_argument, nullptr, BvhOutput},
      {"threads", required_argument, nullptr, Threads},
      {"local-store", required_argument, nullptr, LocalStore},
      {"ray-profile", no_argument, nullptr, RayProfile},
      {"help", no_argument, nullptr, Help},
      {nullptr, 0, nullptr, 0}};
  // What getopt_long() returns for a word that is no option.
  constexpr int PlainWord = 1;
  constexpr unsigned MaxThreads = 1024;
  RunnerOptions Options;
  Options.Threads = std::max(1u, std::thread::hardware_concurrency());
  optind = 1;
  opterr = 0;
  for (;;) {
    Status Parsed = success();
    // The dash keeps the order of the words, so that `--` parts them; the colon
    // tells a missing value from an unknown option.
    switch (
        getopt_long(ArgumentCount, Arguments, "-:o:", LongOptions, nullptr)) {
    case Scene:
      Options.ScenePath = optarg;
      break;
    case Size:
      Parsed = parseImageSize(optarg, Options.Render);
      break;
    case Samples:
      Parsed = parseNumber("--spp", optarg, Options.Render.SamplesPerPixel);
      break;
    case Depth:
      Parsed = parseNumber("--depth", optarg, Options.Render.MaxDepth);
      break;
    case Seed:
      Parsed = parseNumber("--seed", optarg, Options.Render.Seed);
      break;
    case Bvh:
      Parsed = parseBvhOrigin(optarg, Options.Render);
      break;
    case BvhOutput:
      Options.BvhOutputPath = optarg;
      break;
    case Threads:
      Parsed = parseNumber("--threads", optarg, Options.Threads);
      if (Parsed && (Options.Threads < 1 || Options.Threads > MaxThreads))
        Parsed = Error{"--threads: must be from 1 to " +
                       std::to_string(MaxThreads) + ", not " + optarg};
      break;
    case LocalStore:
      Parsed = parseLocalStoreBytes(optarg, Options.LocalStoreBytes);
      break;
    case 'o':
      Options.OutputPath = optarg;
      break;
    case RayProfile:
      Options.RayProfile = true;
      break;
    case Help:
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
      if (Options.ScenePath.empty())
        return Error{"no scene; name one with --scene FILE"};
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
