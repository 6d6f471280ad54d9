# Looks at the code that methods are compiled to, a lane at a time:
#   cmake -D OBJDUMP=objdump -D OBJECTS=a.o;b.o -P early_out_branches.cmake
#
# What cross_product_early_out is there to show is the price of branches, so its
# comparisons must be followed by jumps. The last one of a point gives the
# answer and needs none. In cross_product no comparison of a point is followed
# by one; those of the set-up may be. The same of moller_trumbore_early_out and
# moller_trumbore, which are in one file.
function(count_jumps OBJECT FUNCTION JUMPS COMPARISONS)
  execute_process(COMMAND ${OBJDUMP} -dC --no-show-raw-insn ${OBJECT}
    OUTPUT_VARIABLE CODE COMMAND_ERROR_IS_FATAL ANY)
  # One function: from its label to the next empty line.
  string(REGEX MATCH "<void pitbench::[^\n]*${FUNCTION}[^\n]*float[^\n]*>:\n.*"
    CODE "${CODE}")
  string(FIND "${CODE}" "\n\n" END)
  string(SUBSTRING "${CODE}" 0 ${END} CODE)
  string(REGEX MATCHALL "[ \t]v?u?comiss[ \t]" ALL "${CODE}")
  string(REGEX MATCHALL "[ \t]v?u?comiss[ \t][^\n]*\n[^\n]*[ \t]j[a-z]+[ \t]"
    FOLLOWED "${CODE}")
  list(LENGTH ALL ALL_COUNT)
  list(LENGTH FOLLOWED FOLLOWED_COUNT)
  set(${JUMPS} ${FOLLOWED_COUNT} PARENT_SCOPE)
  set(${COMPARISONS} ${ALL_COUNT} PARENT_SCOPE)
endfunction()

set(SEEN 0)
foreach(OBJECT ${OBJECTS})
  if(OBJECT MATCHES "/cross_product_early_out\\.cc")
    count_jumps(${OBJECT} "OneTriangle<" JUMPS COMPARISONS)
    math(EXPR TWICE "2 * ${JUMPS}")
    math(EXPR SEEN "${SEEN} + 1")
    message("${OBJECT}: ${JUMPS} jumps after ${COMPARISONS} comparisons")
    if(COMPARISONS LESS 3 OR TWICE LESS COMPARISONS)
      message(SEND_ERROR "the early way out is no branch")
    endif()
  elseif(OBJECT MATCHES "kernels_scalar.*/cross_product\\.cc")
    count_jumps(${OBJECT} "OneTriangle<" JUMPS COMPARISONS)
    math(EXPR SEEN "${SEEN} + 1")
    message("${OBJECT}: ${JUMPS} jumps after ${COMPARISONS} comparisons")
    if(COMPARISONS LESS 3 OR JUMPS GREATER 2)
      message(SEND_ERROR "what is compared with it has branches itself")
    endif()
  elseif(OBJECT MATCHES "kernels_scalar.*/moller_trumbore\\.cc")
    count_jumps(${OBJECT} "OneTriangleRays<[^\n]*EarlyOut," JUMPS COMPARISONS)
    count_jumps(${OBJECT} "OneTriangleRays<[^\n]*TwoSided," NONE COMPARISONS)
    math(EXPR SEEN "${SEEN} + 1")
    message("${OBJECT}: ${JUMPS} jumps early, ${NONE} without")
    if(JUMPS LESS 6 OR NONE GREATER 2)
      message(SEND_ERROR "not a branch for each way out, or some without")
    endif()
  endif()
endforeach()
if(SEEN LESS 4)
  message(FATAL_ERROR "${SEEN} objects: are these the kernels'?")
endif()
