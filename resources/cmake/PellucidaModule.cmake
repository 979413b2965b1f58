# One short function for each kind of target.

# pellucida_add_header_set(NAME HEADERS ... LIBRARIES ... [EXECUTABLE])
# Library headers compiled once for all targets that use the set. None of ours: a change to one would recompile everything.
# EXECUTABLE: for test programs, whose position-independent code and optimisation are of another kind.
function(pellucida_add_header_set NAME)
  cmake_parse_arguments(ARG "EXECUTABLE" "" "HEADERS;LIBRARIES" ${ARGN})
  set(source ${CMAKE_CURRENT_BINARY_DIR}/header_sets/${NAME}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "")
  add_library(pellucida_headers_${NAME} OBJECT ${source})
  target_link_libraries(pellucida_headers_${NAME} PRIVATE ${ARG_LIBRARIES} pellucida::build_options)
  target_precompile_headers(pellucida_headers_${NAME} PRIVATE ${ARG_HEADERS})
  if(ARG_EXECUTABLE)
    set_target_properties(pellucida_headers_${NAME} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
    target_compile_options(pellucida_headers_${NAME} PRIVATE -fPIE ${PELLUCIDA_TEST_OPTIONS})
  endif()
endfunction()

# pellucida_add_module(NAME SOURCES ... [PUBLIC ...] [PRIVATE ...] [INCLUDE dir] [HEADER_SET name])
# A static library pellucida_NAME, alias pellucida::NAME. INCLUDE is the folder of its public headers (default: include),
# HEADER_SET one of PellucidaHeaderSets.cmake (default: plain).
function(pellucida_add_module NAME)
  cmake_parse_arguments(ARG "" "INCLUDE;HEADER_SET" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  if(NOT ARG_INCLUDE)
    set(ARG_INCLUDE include)
  endif()
  add_library(pellucida_${NAME} STATIC ${ARG_SOURCES})
  add_library(pellucida::${NAME} ALIAS pellucida_${NAME})
  target_compile_features(pellucida_${NAME} PUBLIC cxx_std_20)
  target_include_directories(pellucida_${NAME} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR}/${ARG_INCLUDE})
  target_link_libraries(pellucida_${NAME} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE} pellucida::build_options)
  if(NOT ARG_HEADER_SET)
    set(ARG_HEADER_SET plain)
  endif()
  target_precompile_headers(pellucida_${NAME} REUSE_FROM pellucida_headers_${ARG_HEADER_SET})
endfunction()

# What lies in tests/<module> sees that module's private parts too.
function(pellucida_see_private_parts NAME)
  target_include_directories(${NAME} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  get_filename_component(module ${CMAKE_CURRENT_SOURCE_DIR} NAME)
  foreach(private_folder ${PROJECT_SOURCE_DIR}/modules/${module}/src ${PROJECT_SOURCE_DIR}/modules/${module}/vtk/src)
    if(EXISTS ${private_folder})
      target_include_directories(${NAME} PRIVATE ${private_folder})
    endif()
  endforeach()
endfunction()

# pellucida_add_test(NAME SOURCES ... [LIBRARIES ...] LABELS ... [WHOLE] [LONG])
# A GoogleTest program; each test case becomes a CTest test with the labels given. The targets tests_threads and tests_memory
# build the programs labelled so: the thread and the address sanitizer run them on every change. WHOLE: the program is one CTest test,
# for cases that share an expensive preparation. LONG: the same, and it runs only with `ctest -C long`. A limit of time is there against hangs alone, the same for all: CMakePresets.json.
function(pellucida_add_test NAME)
  cmake_parse_arguments(ARG "WHOLE;LONG" "" "SOURCES;LIBRARIES;LABELS" ${ARGN})
  add_executable(${NAME} ${ARG_SOURCES})
  target_link_libraries(${NAME} PRIVATE ${ARG_LIBRARIES} pellucida::build_options GTest::gtest_main Threads::Threads)
  target_compile_options(${NAME} PRIVATE ${PELLUCIDA_TEST_OPTIONS})
  target_precompile_headers(${NAME} REUSE_FROM pellucida_headers_tests)
  pellucida_see_private_parts(${NAME})
  # Read by tests that look at the shipped resources, the small test data, or (where it is there) the folder beside the checkout.
  target_compile_definitions(${NAME} PRIVATE PELLUCIDA_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  foreach(label threads memory)
    if(label IN_LIST ARG_LABELS)
      add_dependencies(tests_${label} ${NAME})
    endif()
  endforeach()
  # Several labels become one, "unit+threads": the discovery takes its properties as one flat list, and `ctest -L` matches
  # parts of a label.
  string(REPLACE ";" "+" label "${ARG_LABELS}")
  set(properties LABELS ${label} ENVIRONMENT "VTK_SMP_BACKEND_IN_USE=Sequential")
  # Programs that draw: Mesa's renderer is unloaded before leaks are counted, so that its own have no name to go by.
  if(PELLUCIDA_SANITIZE MATCHES "address" AND label MATCHES "gui|integration")
    list(APPEND properties ENVIRONMENT_MODIFICATION ASAN_OPTIONS=set:detect_leaks=0)
  endif()
  if(ARG_WHOLE OR ARG_LONG)
    if(ARG_LONG)
      set(configurations CONFIGURATIONS long)
    endif()
    add_test(NAME ${NAME} COMMAND ${NAME} ${configurations})
    set_tests_properties(${NAME} PROPERTIES ${properties})
  else()
    # A program of 150 MB whose pages are not in memory yet takes longer to list its tests than the 5 s that are the default.
    gtest_discover_tests(${NAME} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 300 PROPERTIES ${properties})
  endif()
endfunction()

# pellucida_add_benchmark(NAME SOURCES ... [LIBRARIES ...]): a Google Benchmark program.
function(pellucida_add_benchmark NAME)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(${NAME} ${ARG_SOURCES})
  target_link_libraries(${NAME} PRIVATE ${ARG_LIBRARIES} pellucida::build_options benchmark::benchmark_main)
  target_compile_definitions(${NAME} PRIVATE PELLUCIDA_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
endfunction()

# pellucida_add_fuzzer(NAME SOURCES ... [LIBRARIES ...])
# A libFuzzer program; one source has LLVMFuzzerTestOneInput. The target fuzzers builds them all.
function(pellucida_add_fuzzer NAME)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(${NAME} ${ARG_SOURCES})
  target_link_libraries(${NAME} PRIVATE ${ARG_LIBRARIES} pellucida::build_options)
  target_link_options(${NAME} PRIVATE -fsanitize=fuzzer)
  add_dependencies(fuzzers ${NAME})
  pellucida_see_private_parts(${NAME})
endfunction()
