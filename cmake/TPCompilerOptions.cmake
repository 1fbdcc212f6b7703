# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Flags that every C++ target of the project is compiled with.

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

# Asserts stay on in release builds: a wrong simulation is worse than a slow
# one. The inner loops use none.
string(REPLACE "-DNDEBUG" "" CMAKE_CXX_FLAGS_RELEASE
  "${CMAKE_CXX_FLAGS_RELEASE}")

# No contraction: host code computes simulated floats (see docs on floating
# point), and each of them must be rounded as the TP rounds it.
add_compile_options(-Wall -Wextra -Wno-unused-parameter -ffp-contract=off)

set(TP_SANITIZE "" CACHE STRING "Value of -fsanitize= for all targets")
if(TP_SANITIZE)
  add_compile_options(-fsanitize=${TP_SANITIZE} -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${TP_SANITIZE})
endif()

find_program(TP_CCACHE ccache)
if(TP_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${TP_CCACHE})
endif()

include_directories(${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR})
