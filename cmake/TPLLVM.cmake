# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Finds LLVM and Clang 22.1 as Debian ships them (shared libraries, no
# assertions, RTTI on) and offers them as `tp_use_llvm(target)` and
# `tp_use_clang(target)`. The C++ interface makes no promise across versions,
# so the version is pinned.

find_package(LLVM 22.1 REQUIRED CONFIG
  HINTS /usr/lib/llvm-22/lib/cmake/llvm)
find_package(Clang REQUIRED CONFIG
  HINTS ${LLVM_DIR}/../clang NO_DEFAULT_PATH)

list(APPEND CMAKE_MODULE_PATH ${LLVM_DIR})
set(LLVM_TABLEGEN_EXE ${LLVM_TOOLS_BINARY_DIR}/llvm-tblgen)
include(AddLLVM)
include(TableGen)

separate_arguments(TP_LLVM_DEFINITIONS NATIVE_COMMAND "${LLVM_DEFINITIONS}")

function(tp_llvm_compile_options target)
  target_include_directories(${target} SYSTEM PRIVATE ${LLVM_INCLUDE_DIRS})
  target_compile_definitions(${target} PRIVATE ${TP_LLVM_DEFINITIONS})
  target_compile_options(${target} PRIVATE -fno-exceptions)
endfunction()

function(tp_use_llvm target)
  tp_llvm_compile_options(${target})
  target_link_libraries(${target} PRIVATE LLVM)
endfunction()

function(tp_use_clang target)
  tp_use_llvm(${target})
  target_include_directories(${target} SYSTEM PRIVATE ${CLANG_INCLUDE_DIRS})
  target_link_libraries(${target} PRIVATE clang-cpp)
endfunction()
