# Looks at the symbols of the objects that kernels are compiled to:
#   cmake -D NM=nm -D OBJECTS=a.o;b.o -P kernel_symbols.cmake
#
# No weak symbol may be defined there. The linker keeps one copy of each, from
# whichever object it sees first; an inline function compiled for AVX-512 would
# then run on every CPU. And there is no writable data: kernels have no state.
execute_process(COMMAND ${NM} --format=sysv --defined-only ${OBJECTS}
  OUTPUT_VARIABLE SYMBOLS COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^\n]*pitbench[^\n]*" OURS "${SYMBOLS}")
list(LENGTH OURS COUNT)
if(COUNT LESS 100)
  message(FATAL_ERROR "only ${COUNT} symbols: are these the kernels' objects?")
endif()
# Name |Value |Class |Type |Size |Line |Section. Personality routines are the
# same in every object.
string(REGEX MATCHALL "[^\n]*\\|[ ]+[WwVvu][ ]+\\|[^\n]*" WEAK "${SYMBOLS}")
list(FILTER WEAK EXCLUDE REGEX "^DW.ref.__gxx_personality_v0 ")
string(REGEX MATCHALL "[^\n]*\\|\\.(data|bss|tdata|tbss)(\\.[^r][^\n]*)?(\n|$)"
  WRITABLE "${SYMBOLS}")
foreach(SYMBOL ${WEAK} ${WRITABLE})
  message(SEND_ERROR "weak or writable: ${SYMBOL}")
endforeach()
