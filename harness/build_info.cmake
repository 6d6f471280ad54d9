# Writes OUT: the revision that is being built and the flags of every kernel
# file, as harness/measure/machine.cc includes them. Run at every build; the
# file is only touched when something changed.
#   cmake -D SOURCE=… -D COMMANDS=compile_commands.json -D OUT=… -P this file
set(REVISION "unknown")
set(DIRTY false)
find_program(GIT git)
if(GIT AND EXISTS ${SOURCE}/.git)
  execute_process(COMMAND ${GIT} -C ${SOURCE} rev-parse HEAD
    OUTPUT_VARIABLE HEAD OUTPUT_STRIP_TRAILING_WHITESPACE
    RESULT_VARIABLE FAILED ERROR_QUIET)
  if(NOT FAILED)
    set(REVISION ${HEAD})
    # README.md, the pictures it shows and runs kept are of a run: they differ
    # after every measurement and change nothing that is measured.
    execute_process(COMMAND ${GIT} -C ${SOURCE} status --porcelain
        --untracked-files=no -- . ":!README.md" ":!report/readme" ":!report/runs"
      OUTPUT_VARIABLE CHANGES ERROR_QUIET)
    if(CHANGES)
      set(DIRTY true)
    endif()
  endif()
endif()

# What the kernels are made of, so that results tell themselves from those of
# other kernels whatever else a revision changed: SHA-256 over the lines
# "PATH SHA-256" of the files below, by path, without comments and empty lines,
# as these change no kernel. analysis/read/kernel_hash.py does the same.
file(GLOB_RECURSE KERNELS RELATIVE ${SOURCE} ${SOURCE}/kernels/*.cc
  ${SOURCE}/kernels/*.h ${SOURCE}/kernels/*.inc ${SOURCE}/kernels/CMakeLists.txt)
list(SORT KERNELS)
set(LINES "")
foreach(FILE ${KERNELS})
  file(READ ${SOURCE}/${FILE} CODE)
  if(FILE MATCHES "CMakeLists.txt$")
    string(REGEX REPLACE "\n[ \t]*#[^\n]*" "" CODE "\n${CODE}")
  else()
    string(REGEX REPLACE "[ \t]*//[^\n]*" "" CODE "${CODE}")
  endif()
  string(REGEX REPLACE "\n+" "\n" CODE "${CODE}")
  string(STRIP "${CODE}" CODE)
  string(SHA256 DIGEST "${CODE}")
  string(APPEND LINES "${FILE} ${DIGEST}\n")
endforeach()
string(SHA256 KERNEL_HASH "${LINES}")

# The flags say how a file is compiled, not where: no paths, no file names.
file(READ ${COMMANDS} JSON)
string(JSON COUNT LENGTH "${JSON}")
math(EXPR LAST "${COUNT} - 1")
set(FLAGS "")
foreach(K RANGE ${LAST})
  string(JSON FILE GET "${JSON}" ${K} file)
  string(JSON LINE GET "${JSON}" ${K} command)
  if(LINE MATCHES "/kernels_([a-z0-9_]+)\\.dir")
    set(SET ${CMAKE_MATCH_1})
  elseif(LINE MATCHES "peers/CMakeFiles/peers_[a-z0-9_]+\\.dir")
    set(SET library)
  else()
    continue()
  endif()
  cmake_path(RELATIVE_PATH FILE BASE_DIRECTORY ${SOURCE})
  separate_arguments(WORDS UNIX_COMMAND "${LINE}")
  set(LINE "")
  set(SKIP FALSE)
  foreach(WORD ${WORDS})
    if(SKIP)
      set(SKIP FALSE)
    elseif(WORD MATCHES "^(-o|-c|-isystem)$")
      set(SKIP TRUE)
    elseif(WORD MATCHES "^-" AND NOT WORD MATCHES "^(-I|-isystem)")
      string(APPEND LINE " ${WORD}")
    endif()
  endforeach()
  string(STRIP "${LINE}" LINE)
  string(APPEND FLAGS "    {\"${FILE}\", \"${SET}\", \"${LINE}\"},\n")
endforeach()

set(TEXT "constexpr char kRevision[] = \"${REVISION}\";
constexpr bool kDirty = ${DIRTY};
constexpr char kKernelHash[] = \"${KERNEL_HASH}\";
constexpr KernelFlags kFlags[] = {
${FLAGS}};
")
set(OLD "")
if(EXISTS ${OUT})
  file(READ ${OUT} OLD)
endif()
if(NOT OLD STREQUAL TEXT)
  file(WRITE ${OUT} "${TEXT}")
endif()
