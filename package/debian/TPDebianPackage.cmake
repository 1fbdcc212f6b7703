# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The Debian package: `cpack` in the build folder.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME ${TP_PACKAGE_NAME})
set(CPACK_PACKAGE_CONTACT "The TP project <tp-toolchain@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY
  "compiler and simulator of a ray-tracing chip")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"tpcc compiles C and C++20 for the thread processors (TP) of a simulated
ray-tracing chip, and tpsim runs the program and says where the cycles went.
With the assembler, the disassembler, the TP's C library, chip descriptions,
the sources of the rendering kernels, and a CMake package: find_package(TP).")
set(CPACK_DEBIAN_PACKAGE_SECTION devel)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION TRUE)
set(CPACK_STRIP_FILES TRUE)

# The shared libraries are found by dpkg-shlibdeps. Headers of libstdc++ and of
# clang stay in their own packages; the toolchain file needs llvm-ar.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
string(JOIN ", " CPACK_DEBIAN_PACKAGE_DEPENDS
  libstdc++-${TP_LIBSTDCXX_VERSION}-dev
  libclang-common-${LLVM_VERSION_MAJOR}-dev
  llvm-${LLVM_VERSION_MAJOR}
  "python3 (>= 3.11)")
string(JOIN ", " CPACK_DEBIAN_PACKAGE_RECOMMENDS
  cmake "ninja-build | make")
string(JOIN ", " CPACK_DEBIAN_PACKAGE_SUGGESTS
  clang-${LLVM_VERSION_MAJOR} clangd-${LLVM_VERSION_MAJOR} g++)

install(FILES ${CMAKE_CURRENT_LIST_DIR}/copyright DESTINATION share/doc/${TP_PACKAGE_NAME})

include(CPack)
