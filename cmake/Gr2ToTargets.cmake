# Compiler settings that every target of the project shares.
function(gr2to_target_defaults target)
  target_compile_features(${target} PUBLIC cxx_std_17)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion -Wshadow)
  if(GR2TO_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(GR2TO_SANITIZE)
    # Undefined behaviour ends the program, as a bad access does, so that a test fails by it.
    target_compile_options(${target} PRIVATE -fsanitize=${GR2TO_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PRIVATE -fsanitize=${GR2TO_SANITIZE})
    # What a folder sets for its own programs, to compile faster.
    target_compile_options(${target} PRIVATE ${GR2TO_SANITIZE_ALSO})
  endif()
  if(GR2TO_COVERAGE)
    target_compile_options(${target} PRIVATE --coverage)
    target_link_options(${target} PRIVATE --coverage)
  endif()
endfunction()

# Parses the headers that take longest once for all sources of a target. Sources name what they use all the same: clang-tidy
# reads them without.
function(gr2to_precompile target)
  if(GR2TO_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()

# Sources that make objects of MRPT's scenes: their classes have an over-aligned virtual base, whose alignment g++ wrongly
# demands of every part of them when it checks for misaligned accesses.
function(gr2to_without_alignment_check)
  if(GR2TO_SANITIZE)
    set_property(SOURCE ${ARGN} APPEND PROPERTY COMPILE_OPTIONS -fno-sanitize=alignment)
  endif()
endfunction()
