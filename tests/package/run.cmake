# Installs the build to a fresh prefix, then configures, builds and runs the consumer project against it.
#
#   cmake -D BUILD_DIR=... -D WORK_DIR=... -D CONFIG=... -D GENERATOR=... -D CXX_COMPILER=... -D VERSION=... -P run.cmake

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(prefix "${WORK_DIR}/prefix")
file(REMOVE_RECURSE "${WORK_DIR}")
run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --config "${CONFIG}" --prefix "${prefix}")

# The library's own dependencies are hidden from the consumer: it may need none of them.
run("${CMAKE_COMMAND}"
    -S "${CMAKE_CURRENT_LIST_DIR}"
    -B "${WORK_DIR}/build"
    -G "${GENERATOR}"
    -D "CMAKE_CXX_COMPILER=${CXX_COMPILER}"
    -D "CMAKE_BUILD_TYPE=${CONFIG}"
    -D "CMAKE_PREFIX_PATH=${prefix}"
    -D CMAKE_FIND_USE_PACKAGE_REGISTRY=OFF
    -D CMAKE_DISABLE_FIND_PACKAGE_Boost=ON
    -D CMAKE_DISABLE_FIND_PACKAGE_CLI11=ON
    -D CMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON
    -D CMAKE_DISABLE_FIND_PACKAGE_nlohmann_json=ON)
run("${CMAKE_COMMAND}" --build "${WORK_DIR}/build" --config "${CONFIG}")

execute_process(COMMAND "${WORK_DIR}/build/consumer" OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
if(NOT output STREQUAL "brdfplot ${VERSION}: 0.1\n")
  message(FATAL_ERROR "The consumer printed: ${output}")
endif()

# Files that tell the version to other tools.
foreach(file IN ITEMS vcpkg.json CITATION.cff)
  file(STRINGS "${CMAKE_CURRENT_LIST_DIR}/../../${file}" line REGEX "^[ \"]*version\"?: ")
  if(NOT line MATCHES "[ \"]${VERSION}[\",]*$")
    message(FATAL_ERROR "${file} says ${line}; the project's version is ${VERSION}")
  endif()
endforeach()

# An installed header that includes what is not installed would only fail in the consumer who needs it.
file(GLOB_RECURSE headers RELATIVE "${prefix}/include/brdfplot" "${prefix}/include/brdfplot/*.hpp")
list(TRANSFORM headers REPLACE "(.+)" "#include \"\\1\"" OUTPUT_VARIABLE includes)
list(JOIN includes "\n" includes)
file(WRITE "${WORK_DIR}/all.cpp" "${includes}\n")
run("${CXX_COMPILER}" -std=c++20 -fsyntax-only -Wall -Wextra -Werror "-I${prefix}/include/brdfplot"
    "${WORK_DIR}/all.cpp")
foreach(header IN LISTS headers)
  file(STRINGS "${prefix}/include/brdfplot/${header}" third_party REGEX "^ *# *include *<(nlohmann|boost|Eigen|CLI|embree3|tbb)/")
  if(third_party)
    message(FATAL_ERROR "An installed header, ${header}, has ${third_party}")
  endif()
endforeach()

# The installed command, away from its source tree.
set(command "${prefix}/bin/brdfplot")
if(EXISTS "${command}")
  run("${command}" --version)
  # The schemas that the configs name.
  if(EXISTS "${prefix}/share/brdfplot/configs/schemas")
    foreach(kind IN ITEMS material figure report scene advice)
      execute_process(COMMAND "${command}" schema ${kind} OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
      file(READ "${prefix}/share/brdfplot/configs/schemas/${kind}.json" installed)
      if(NOT printed STREQUAL installed)
        message(FATAL_ERROR "The installed schema of ${kind} is another than the one printed")
      endif()
    endforeach()
  endif()
endif()
