# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# tp_add_kernel(<name> SOURCES <file>...
#   [OPTIONS <option of tpcc>...]         also at the link; see below
#   [DEFINITIONS <name>[=<value>]...]
#   [INCLUDE_DIRECTORIES <folder>...]
#   [CHIP <name or file>]                 that run-<name> simulates
#   [RUN_OPTIONS <option of tpsim>...] [ARGUMENTS <argument of the program>...]
#   [NATIVE] [NATIVE_OPTIONS <option of the host's compiler>...])
#
# makes these targets:
#
#   <name>          the program, <name>.elf, in the folder of executables
#   run-<name>      runs it on tpsim
#   <name>-native   with NATIVE: the same sources for the host
#   <name>-clangd   for entries of compile_commands.json; is never built
#
# It works in a project of the host, whose compiler then compiles none of the
# program, and in one that uses TPToolchain.cmake, which leaves NATIVE out. The
# build type chooses the optimization, as elsewhere in CMake, but without one it
# is -O3; lines of source (-g) are always there for tpsim's messages. OPTIONS
# stand behind both.
#
# tp_kernel_file(<name> <variable>): the path of the program of tp_add_kernel(),
# which may be a generator expression, for tests and custom commands.

set(_TP_SOURCE_FILE_PATTERN "\\.(c|cc|cpp|cxx|C|s|S|ll|bc|o|a)$")

function(tp_kernel_file name variable)
  if(NOT TARGET ${name})
    message(FATAL_ERROR "tp_kernel_file: there is no target '${name}'; "
      "make it with tp_add_kernel")
  endif()
  get_target_property(file ${name} TP_KERNEL_FILE)
  if(NOT file)
    message(FATAL_ERROR "tp_kernel_file: '${name}' is no kernel; "
      "make it with tp_add_kernel")
  endif()
  set(${variable} ${file} PARENT_SCOPE)
endfunction()

# What the build type means to tpcc, as CMake has it for Clang.
function(_tp_build_type_options variable)
  set(other_types $<NOT:$<CONFIG:Debug,RelWithDebInfo,MinSizeRel>>)
  set(${variable}
    $<$<CONFIG:Debug>:-O0> $<$<CONFIG:RelWithDebInfo>:-O2>
    $<$<CONFIG:MinSizeRel>:-Os> $<${other_types}:-O3>
    $<$<CONFIG:Release,RelWithDebInfo,MinSizeRel>:-DNDEBUG>
    PARENT_SCOPE)
endfunction()

# Sets \p variable to the path of the object of \p source.
function(_tp_object_file name source variable)
  file(RELATIVE_PATH path ${CMAKE_CURRENT_SOURCE_DIR} ${source})
  string(REPLACE "../" "__/" path ${path})
  set(object ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${name}.tp/${path}.o)
  get_filename_component(folder ${object} DIRECTORY)
  file(MAKE_DIRECTORY ${folder})
  set(${variable} ${object} PARENT_SCOPE)
endfunction()

# The program by custom commands, in a project of the host.
function(_tp_build_for_host_project name sources options)
  set(folder ${CMAKE_CURRENT_BINARY_DIR})
  if(CMAKE_RUNTIME_OUTPUT_DIRECTORY)
    set(folder ${CMAKE_RUNTIME_OUTPUT_DIRECTORY})
  endif()
  set(elf ${folder}/${name}.elf)
  set(objects)
  foreach(source IN LISTS sources)
    _tp_object_file(${name} ${source} object)
    # Bitcode, so that the link optimizes the program as a whole.
    add_custom_command(OUTPUT ${object}
      COMMAND TP::tpcc ${options} -flto -c ${source} -o ${object}
        -MD -MF ${object}.d -MT ${object}
      DEPENDS ${source} TP::tpcc
      DEPFILE ${object}.d
      COMMENT "Compiling ${source} for the TP"
      COMMAND_EXPAND_LISTS VERBATIM)
    list(APPEND objects ${object})
  endforeach()
  add_custom_command(OUTPUT ${elf}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
    COMMAND TP::tpcc ${options} ${objects} -o ${elf}
    DEPENDS ${objects} TP::tpcc
    COMMENT "Linking ${name}.elf"
    COMMAND_EXPAND_LISTS VERBATIM)
  add_custom_target(${name} ALL DEPENDS ${elf})
  set_target_properties(${name} PROPERTIES TP_KERNEL_FILE ${elf})
endfunction()

# The same in a project whose compiler is tpcc.
function(_tp_build_with_toolchain name sources options)
  add_executable(${name} ${sources})
  target_compile_options(${name} PRIVATE ${options})
  target_link_options(${name} PRIVATE ${options})
  set_target_properties(${name} PROPERTIES
    EXPORT_COMPILE_COMMANDS OFF
    TP_KERNEL_FILE $<TARGET_FILE:${name}>)
endfunction()

# The native executable: the kernel's main() runs on threads of the host.
function(_tp_build_natively name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" ""
    "SOURCES;OPTIONS;INCLUDE_DIRECTORIES;DEFINITIONS")
  get_property(languages GLOBAL PROPERTY ENABLED_LANGUAGES)
  if(NOT "CXX" IN_LIST languages)
    message(FATAL_ERROR "tp_add_kernel: ${name} needs a compiler of the host; "
      "write project(... LANGUAGES CXX), or leave NATIVE out")
  endif()
  add_executable(${name} ${arg_SOURCES})
  target_compile_definitions(${name} PRIVATE
    main=tpKernelMain ${arg_DEFINITIONS})
  target_compile_features(${name} PRIVATE cxx_std_20)
  target_compile_options(${name} PRIVATE -ffp-contract=off ${arg_OPTIONS})
  target_include_directories(${name} PRIVATE ${arg_INCLUDE_DIRECTORIES})
  target_link_libraries(${name} PRIVATE TP::Native)
  set_target_properties(${name} PROPERTIES EXPORT_COMPILE_COMMANDS OFF)
endfunction()

function(tp_add_kernel name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "NATIVE" "CHIP"
    "SOURCES;OPTIONS;DEFINITIONS;INCLUDE_DIRECTORIES;RUN_OPTIONS;ARGUMENTS;NATIVE_OPTIONS")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "tp_add_kernel(${name}): what is "
      "'${arg_UNPARSED_ARGUMENTS}'? Sources stand behind SOURCES")
  endif()
  if(arg_KEYWORDS_MISSING_VALUES)
    message(FATAL_ERROR "tp_add_kernel(${name}): nothing behind "
      "${arg_KEYWORDS_MISSING_VALUES}")
  endif()
  if(NOT arg_SOURCES)
    message(FATAL_ERROR "tp_add_kernel(${name}): no SOURCES")
  endif()

  set(sources)
  foreach(source IN LISTS arg_SOURCES)
    get_filename_component(source ${source} ABSOLUTE)
    if(source MATCHES "${_TP_SOURCE_FILE_PATTERN}")
      list(APPEND sources ${source})
    elseif(NOT source MATCHES "\\.(h|hh|hpp|inc|def)$")
      message(FATAL_ERROR "tp_add_kernel(${name}): ${source} has no ending of "
        "C, C++, assembly, LLVM IR or an object")
    endif()
  endforeach()
  set(folders)
  foreach(folder IN LISTS arg_INCLUDE_DIRECTORIES)
    get_filename_component(folder ${folder} ABSOLUTE)
    list(APPEND folders ${folder})
  endforeach()
  set(options -g ${arg_OPTIONS})
  list(TRANSFORM arg_DEFINITIONS PREPEND -D OUTPUT_VARIABLE definitions)
  list(TRANSFORM folders PREPEND -I OUTPUT_VARIABLE includes)
  list(APPEND options ${definitions} ${includes})

  if(CMAKE_SYSTEM_PROCESSOR STREQUAL "tp")
    if(arg_NATIVE)
      message(STATUS "${name}-native is left out: this is no build of the host")
    endif()
    _tp_build_with_toolchain(${name} "${sources}" "${options}")
  else()
    _tp_build_type_options(optimization)
    _tp_build_for_host_project(${name} "${sources}"
      "${optimization};${options}")
    if(arg_NATIVE)
      _tp_build_natively(${name}-native
        SOURCES ${sources} OPTIONS ${arg_NATIVE_OPTIONS}
        DEFINITIONS ${arg_DEFINITIONS} INCLUDE_DIRECTORIES ${folders})
    endif()
  endif()
  tp_add_clangd_view(${name}-clangd
    SOURCES ${sources} OPTIONS ${arg_OPTIONS}
    DEFINITIONS ${arg_DEFINITIONS} INCLUDE_DIRECTORIES ${folders})

  tp_kernel_file(${name} elf)
  set(chip)
  if(arg_CHIP)
    set(chip --chip ${arg_CHIP})
  endif()
  set(arguments)
  if(arg_ARGUMENTS)
    set(arguments -- ${arg_ARGUMENTS})
  endif()
  add_custom_target(run-${name}
    COMMAND TP::tpsim ${chip} ${arg_RUN_OPTIONS} ${elf} ${arguments}
    DEPENDS ${name}
    USES_TERMINAL VERBATIM)
endfunction()
