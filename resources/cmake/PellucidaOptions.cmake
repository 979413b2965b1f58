# Build options and the flags every target of ours carries (pellucida::build_options).
option(PELLUCIDA_WARNINGS_AS_ERRORS "Treat compiler warnings as errors" OFF)
option(PELLUCIDA_CORE_ONLY "Build only the targets without VTK, Qt, OpenCV and ITK" OFF)
option(PELLUCIDA_FUZZ "Build the fuzzers too; needs clang" OFF)
option(PELLUCIDA_BUILD_TESTS "Build the tests and benchmarks" ${PROJECT_IS_TOP_LEVEL})
option(PELLUCIDA_INSTALL "Install rules and the Debian package" ${PROJECT_IS_TOP_LEVEL})
option(PELLUCIDA_UNITY "Compile files in batches and library headers once: a clean build in less than half the time" OFF)
set(PELLUCIDA_SANITIZE "" CACHE STRING "Sanitizers to compile with, as -fsanitize takes them")

# These hold in this project's folders; a project that adds this one keeps its own.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

# Small batches: a change to one file recompiles the other seven. Without the option each file is compiled alone and
# must include what it uses.
set(CMAKE_UNITY_BUILD ${PELLUCIDA_UNITY})
set(CMAKE_UNITY_BUILD_BATCH_SIZE 8)
if(NOT PELLUCIDA_UNITY)
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
endif()

# Where things go and who compiles is the outermost project's to say.
if(PROJECT_IS_TOP_LEVEL)
  set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
  set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/lib")
  set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/lib")
  find_program(CCACHE_PROGRAM ccache)
  if(CCACHE_PROGRAM)
    set(CMAKE_CXX_COMPILER_LAUNCHER "${CCACHE_PROGRAM}")
    if(PELLUCIDA_UNITY)
      # What ccache asks for to keep precompiled headers; nothing of ours uses __DATE__ or __TIME__.
      set(sloppiness pch_defines,time_macros,include_file_mtime,include_file_ctime)
      list(PREPEND CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=${sloppiness})
    endif()
  endif()
endif()

add_library(pellucida_build_options INTERFACE)
add_library(pellucida::build_options ALIAS pellucida_build_options)
# No contraction and no fast-math: a replay must give the same bits as the live run.
target_compile_options(pellucida_build_options INTERFACE -Wall -Wextra -Wshadow -Wno-missing-field-initializers -ffp-contract=off)
if(PELLUCIDA_UNITY)
  # SDL's flags define it; a precompiled header is good only where the same is defined.
  target_compile_definitions(pellucida_build_options INTERFACE _REENTRANT)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # GCC takes each class of a batch that has a member from an unnamed namespace for one in a header.
    target_compile_options(pellucida_build_options INTERFACE -Wno-subobject-linkage)
  endif()
endif()
if(PELLUCIDA_WARNINGS_AS_ERRORS)
  target_compile_options(pellucida_build_options INTERFACE -Werror)
endif()
if(CMAKE_BUILD_TYPE STREQUAL "Debug")
  target_compile_definitions(pellucida_build_options INTERFACE _GLIBCXX_ASSERTIONS)
endif()
if(PELLUCIDA_SANITIZE)
  target_compile_options(pellucida_build_options INTERFACE -fsanitize=${PELLUCIDA_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(pellucida_build_options INTERFACE -fsanitize=${PELLUCIDA_SANITIZE})
  if(PELLUCIDA_SANITIZE MATCHES "undefined")
    # Four checks before each access to memory, most of which the address sanitizer makes too: with them the finite
    # elements take 15 times as long.
    target_compile_options(pellucida_build_options INTERFACE -fno-sanitize=null,alignment,object-size,pointer-overflow)
  endif()
endif()
if(PELLUCIDA_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "PELLUCIDA_FUZZ needs clang, not ${CMAKE_CXX_COMPILER_ID}; use cmake --preset asan")
  endif()
  # Everything counts its branches for the fuzzer; the fuzzers alone carry its main function.
  target_compile_options(pellucida_build_options INTERFACE -fsanitize=fuzzer-no-link)
endif()

# Test programs themselves: what takes time when they run lies in the libraries, and the rest compiles in two thirds of the time.
if(NOT CMAKE_BUILD_TYPE STREQUAL "Debug")
  set(PELLUCIDA_TEST_OPTIONS -O1)
endif()

# For files that use ITK: Debian's headers refuse any compiler but GCC by name.
set(PELLUCIDA_ITK_OPTIONS "$<$<CXX_COMPILER_ID:Clang>:-include;${CMAKE_CURRENT_LIST_DIR}/itk_with_clang.h>")
