# bodkin_module(NAME [PARSES] [FOLDERS dir...] [EXCEPT file...] [LINK target...] [PRIVATE_LINK target...])
#
# Builds the static library bodkin_NAME (alias bodkin::NAME) from every source file of the calling folder, or of the
# FOLDERS below it, EXCEPT some. LINK lists dependencies of public headers, PRIVATE_LINK those of source files only.
# PARSES: the module reads foreign bytes, so the fuzzers need its coverage.

set(BODKIN_WARNINGS -Wall -Wextra -Wpedantic -Wshadow -Wcast-qual -Wimplicit-fallthrough
    $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor> $<$<COMPILE_LANGUAGE:CXX>:-Wold-style-cast>
    $<$<COMPILE_LANGUAGE:CXX>:-Woverloaded-virtual>
    -Wno-missing-field-initializers)  # designated initialisers list only differences from the defaults

# With sanitizers these modules compile in half the time when not optimised, and compute little themselves.
set(BODKIN_UNOPTIMISED_UNDER_SANITIZERS "^bodkin_(cli|io|io_images|link|report.*)$")

# These read, arrange and print; with little optimisation they compile in a quarter less time.
set(BODKIN_OPTIMISED_LITTLE "^bodkin_(app|link|report)$")

# These compute nothing: cli reads arguments and prints, report_teacher serves a page to a browser. Without optimisation
# they compile in a third of the time. Programs that link them call bodkin_libraries_first().
set(BODKIN_UNOPTIMISED "^bodkin_(cli|report_teacher)$")

# These compute and draw: they read no foreign bytes, talk to no device, and use several threads only through core's
# ThreadPool. The address sanitizer's build compiles them without the sanitizer, unless BODKIN_SANITIZE_ALL is on: with
# it they take 1.5 to 1.8 times as long to compile, and the tests of commands longer too.
set(BODKIN_COMPUTES "^bodkin_(forces|study|imaging|volume_rendering|ultrasound|ultrasound_screen|scan_kernel_[a-z0-9]+\
|patient_synthetic|patient_planning|patient_shoulder)$")
if(BODKIN_SANITIZE_ALL OR NOT BODKIN_SANITIZERS MATCHES address)
  set(BODKIN_COMPUTES "^$")
endif()

# Compiler settings shared by all Bodkin targets. Floating point is kept strict (no contraction into fused
# multiply-add) so that a recording replays to the same bits with any compiler and machine.
function(bodkin_settings target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(${target} PRIVATE ${BODKIN_WARNINGS} -ffp-contract=off)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  if(CMAKE_UNITY_BUILD)
    # In a unity file, clashing names of neighbours and includes of former source files are not errors.
    target_compile_options(${target} PRIVATE -Wno-shadow
      $<$<CXX_COMPILER_ID:GNU>:-Wshadow=local> $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-subobject-linkage>)
  endif()
  if(BODKIN_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(BODKIN_SANITIZERS MATCHES address)
    target_compile_definitions(${target} PRIVATE BODKIN_ADDRESS_SANITIZER)
  elseif(BODKIN_SANITIZERS MATCHES thread)
    target_compile_definitions(${target} PRIVATE BODKIN_THREAD_SANITIZER)
  endif()
  if(BODKIN_SANITIZERS)
    target_link_options(${target} PUBLIC -fsanitize=${BODKIN_SANITIZERS})
  endif()
  if(BODKIN_SANITIZERS AND NOT target MATCHES "${BODKIN_COMPUTES}")
    target_compile_options(${target} PRIVATE -fsanitize=${BODKIN_SANITIZERS} -fno-omit-frame-pointer
                           -fno-sanitize-recover=all)
    if(BODKIN_SANITIZERS MATCHES undefined)
      # These two checks at every access to an object lengthen the build; the address sanitizer also finds their
      # errors, a null pointer and an access outside an object.
      target_compile_options(${target} PRIVATE -fno-sanitize=null,object-size)
    endif()
  endif()
endfunction()

function(bodkin_module name)
  cmake_parse_arguments(ARG "PARSES" "" "FOLDERS;EXCEPT;LINK;PRIVATE_LINK" ${ARGN})
  if(NOT ARG_FOLDERS)
    set(ARG_FOLDERS ".")
  endif()
  set(patterns "")
  foreach(folder IN LISTS ARG_FOLDERS)
    list(APPEND patterns "${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp" "${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.h")
  endforeach()
  file(GLOB sources CONFIGURE_DEPENDS ${patterns})
  list(TRANSFORM sources REPLACE "/\\./" "/")
  list(TRANSFORM ARG_EXCEPT PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/")
  list(REMOVE_ITEM sources ${ARG_EXCEPT})
  add_library(bodkin_${name} STATIC ${sources})
  add_library(bodkin::${name} ALIAS bodkin_${name})
  set_target_properties(bodkin_${name} PROPERTIES EXPORT_NAME ${name} LINKER_LANGUAGE CXX)
  target_include_directories(bodkin_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/bodkin>)
  target_link_libraries(bodkin_${name} PUBLIC ${ARG_LINK} PRIVATE ${ARG_PRIVATE_LINK})
  bodkin_settings(bodkin_${name})
  cmake_path(GET CMAKE_CURRENT_SOURCE_DIR FILENAME folder_of_module)
  set_target_properties(bodkin_${name} PROPERTIES BODKIN_MODULE ${folder_of_module})
  if(BODKIN_PRECOMPILED)
    bodkin_precompiled(bodkin_${name})
  endif()
  if(BODKIN_SANITIZERS AND bodkin_${name} MATCHES "${BODKIN_UNOPTIMISED_UNDER_SANITIZERS}")
    target_compile_options(bodkin_${name} PRIVATE -O0)
  endif()
  if(CMAKE_BUILD_TYPE STREQUAL Release AND bodkin_${name} MATCHES "${BODKIN_OPTIMISED_LITTLE}")
    target_compile_options(bodkin_${name} PRIVATE -O1)
  elseif(CMAKE_BUILD_TYPE STREQUAL Release AND bodkin_${name} MATCHES "${BODKIN_UNOPTIMISED}")
    target_compile_options(bodkin_${name} PRIVATE -O0)
  endif()
  if(BODKIN_FUZZERS AND ARG_PARSES)
    target_compile_options(bodkin_${name} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
endfunction()

# bodkin_large_blocks(PROGRAM): its operator new requests large pages for large blocks.
function(bodkin_large_blocks program)
  if(TARGET bodkin_large_block_new)
    target_link_libraries(${program} PRIVATE bodkin_large_block_new)
  endif()
endfunction()

# bodkin_uses_itk(TARGET): the requirements of sources that include ITK.
function(bodkin_uses_itk target)
  target_include_directories(${target} SYSTEM PRIVATE ${ITK_INCLUDE_DIRS})
  # ITK's headers contain an older Eigen with the same include guards: ours must come first, and completely.
  target_compile_options(${target} PRIVATE "SHELL:-include Eigen/Dense")
  if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
    target_compile_options(${target} PRIVATE "SHELL:-include ${PROJECT_SOURCE_DIR}/cmake/itk_compiled_by_clang.h")
  endif()
  if(BODKIN_SANITIZERS MATCHES undefined)
    # ITK's neighbourhood iterators decrement a null pointer that they never read.
    target_compile_options(${target} PRIVATE -fno-sanitize=pointer-overflow)
  endif()
endfunction()

# bodkin_modules_below(RESULT target...): the libraries of modules among these targets and their dependencies.
function(bodkin_modules_below result)
  set(found "")
  while(ARGN)
    list(POP_FRONT ARGN target)
    string(REGEX REPLACE "^bodkin::" "bodkin_" target "${target}")
    if(target MATCHES "^bodkin_" AND NOT target IN_LIST found)
      list(APPEND found ${target})
      get_target_property(linked ${target} LINK_LIBRARIES)
      list(APPEND ARGN ${linked})
    endif()
  endwhile()
  set(${result} ${found} PARENT_SCOPE)
endfunction()

# bodkin_libraries_first(PROGRAM target...): for a program that is not optimised itself, or links modules that are not.
# The linker keeps the first copy of an inline function used by several: this makes it that of an optimised module, and
# in a sanitizer's build of a sanitized one.
function(bodkin_libraries_first program)
  bodkin_modules_below(modules ${ARGN})
  if(BODKIN_SANITIZERS)
    list(FILTER modules EXCLUDE REGEX "${BODKIN_UNOPTIMISED_UNDER_SANITIZERS}")
    list(FILTER modules EXCLUDE REGEX "${BODKIN_COMPUTES}")
  else()
    list(FILTER modules EXCLUDE REGEX "${BODKIN_UNOPTIMISED}")
  endif()
  list(TRANSFORM modules REPLACE "(.+)" "$<TARGET_FILE:\\1>")
  list(JOIN modules "," modules)
  target_link_options(${program} PRIVATE "LINKER:--whole-archive,${modules},--no-whole-archive")
endfunction()
