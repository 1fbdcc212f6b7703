# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Entries of compile_commands.json that clangd understands.

# Rewrites the options of tpcc in the list \p variable to those that clang has.
function(_tp_options_for_clangd variable)
  set(options ${${variable}})
  if("-mfma" IN_LIST options)
    list(APPEND options -D__TP_FMA__ -D__FP_FAST_FMAF)
  endif()
  if("-mno-trig" IN_LIST options)
    list(APPEND options -U__TP_TRIG__)
  endif()
  if("-ftp-check-fp" IN_LIST options)
    list(APPEND options -D__TP_CHECK_FP__)
  endif()
  list(FILTER options EXCLUDE REGEX
    "^-(m(no-)?(trig|fma)|f(no-)?tp-.*|W.*tp-.*|Wl,.*)$")
  set(${variable} ${options} PARENT_SCOPE)
endfunction()

# tp_add_clangd_view(name SOURCES file... [OPTIONS ...] [INCLUDE_DIRECTORIES ...]
# [DEFINITIONS ...]): a target that nobody builds. Its entries in
# compile_commands.json stand for tpcc's, with options for clang's front end.
function(tp_add_clangd_view name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" ""
    "SOURCES;OPTIONS;INCLUDE_DIRECTORIES;DEFINITIONS")
  get_property(languages GLOBAL PROPERTY ENABLED_LANGUAGES)
  if(NOT "CXX" IN_LIST languages)
    message(STATUS "compile_commands.json has no entries for ${name}: "
      "the project does not enable the language CXX")
    return()
  endif()
  _tp_options_for_clangd(arg_OPTIONS)
  add_library(${name} OBJECT EXCLUDE_FROM_ALL ${arg_SOURCES})
  target_compile_options(${name} PRIVATE
    --config=${TP_CLANGD_CONFIG}
    $<$<COMPILE_LANGUAGE:CXX>:-std=gnu++20>
    ${arg_OPTIONS})
  target_include_directories(${name} PRIVATE ${arg_INCLUDE_DIRECTORIES})
  target_compile_definitions(${name} PRIVATE ${arg_DEFINITIONS})
  set_target_properties(${name} PROPERTIES EXPORT_COMPILE_COMMANDS ON)
endfunction()
