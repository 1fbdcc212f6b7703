# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Configuration of all lit suites. Our tools and LLVM's are on the PATH."""

import os
import shutil
import sys

import lit.formats

config.name = "tp"
config.test_format = lit.formats.ShTest(execute_external=False)
config.suffixes = [".ll", ".s", ".S", ".c", ".cpp", ".test", ".mir", ".yaml"]
config.excludes = ["Inputs", "unit", "CMakeLists.txt"]
config.test_source_root = os.path.join(config.tp_source_dir, "test")
config.test_exec_root = os.path.join(config.tp_build_dir, "test")

bin_dir = os.path.join(config.tp_build_dir, "bin")
config.environment["PATH"] = os.pathsep.join(
    [bin_dir, config.llvm_tools_dir, config.environment["PATH"]]
)
config.environment["LC_ALL"] = "C"
config.environment["NODE_PATH"] = os.path.join(
    config.tp_build_dir, "node", "node_modules")

backend = os.path.join(config.tp_build_dir, "lib", "libLLVMTP.so")
config.substitutions += [
    ("%llc_tp",
     f"llc -verify-machineinstrs -load {backend} -mtriple=tp-unknown-elf"),
    ("%tp_backend", backend),
    ("%tp_bin", bin_dir),
    ("%tp_build", config.tp_build_dir),
    ("%tp_instructions",
     os.path.join(config.tp_build_dir, "llvm-backend", "TPInstrs.json")),
    ("%source_dir", config.tp_source_dir),
    ("%scenes", os.path.join(config.tp_source_dir, "scenes")),
    ("%kernels", os.path.join(config.tp_source_dir, "kernels")),
    ("%host_cc", config.host_cc),
    ("%host_cxx", config.host_cxx),
    ("%python", sys.executable),
    ("%profile_schema",
     os.path.join(config.tp_build_dir, "share", "tp", "profile.schema.json")),
    ("%statistics_schema",
     os.path.join(config.tp_build_dir, "share", "tp", "statistics.schema.json")),
]

if shutil.which("gdb"):
    config.available_features.add("gdb")
