# Installs the build to a fresh prefix, then configures, builds and runs the consumer project against it.
#
#   cmake -D BUILD_DIR=... -D WORK_DIR=... -D CONFIG=... -D GENERATOR=... -D CXX_COMPILER=... -D VERSION=... -P run.cmake

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(prefix "${WORK_DIR}/prefix")
file(REMOVE_RECURSE "${WORK_DIR}")
run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --config "${CONFIG}" --prefix "${prefix}")

# What is exported holds wherever the installation is moved to, and on machines whose libraries stand elsewhere.
file(GLOB_RECURSE exported "${prefix}/*.cmake")
if(NOT exported)
  message(FATAL_ERROR "No CMake files are installed in ${prefix}")
endif()
foreach(file IN LISTS exported)
  file(STRINGS "${file}" absolute REGEX "[\";:>=]/[A-Za-z0-9]")
  if(absolute)
    message(FATAL_ERROR "${file} has an absolute path: ${absolute}")
  endif()
endforeach()

# Builds the project in `folder`, from which `hidden` packages are hidden: it may need none of them.
function(build_consumer folder binary_dir hidden)
  list(TRANSFORM hidden REPLACE "(.+)" "-DCMAKE_DISABLE_FIND_PACKAGE_\\1=ON")
  run("${CMAKE_COMMAND}"
      -S "${folder}"
      -B "${binary_dir}"
      -G "${GENERATOR}"
      -D "CMAKE_CXX_COMPILER=${CXX_COMPILER}"
      -D "CMAKE_BUILD_TYPE=${CONFIG}"
      -D "CMAKE_PREFIX_PATH=${prefix}"
      -D CMAKE_FIND_USE_PACKAGE_REGISTRY=OFF
      ${hidden}
      ${ARGN})
  run("${CMAKE_COMMAND}" --build "${binary_dir}" --config "${CONFIG}")
endfunction()
set(header_only Boost CLI11 Eigen3 nlohmann_json)
build_consumer("${CMAKE_CURRENT_LIST_DIR}" "${WORK_DIR}/build" "${header_only}")

execute_process(COMMAND "${WORK_DIR}/build/consumer" OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
if(NOT output STREQUAL "brdfplot ${VERSION}: 0.1\n")
  message(FATAL_ERROR "The consumer printed: ${output}")
endif()

# The core by itself, with the example of the README: the program loads none of the libraries of the rest.
file(READ "${CMAKE_CURRENT_LIST_DIR}/../../README.md" readme)
if(NOT readme MATCHES "\n```cpp\n([^`]*)```\n+```text\n([^`]*)```\n")
  message(FATAL_ERROR "README.md has no C++ example with what it prints")
endif()
set(shown "${CMAKE_MATCH_2}")
file(CONFIGURE OUTPUT "${WORK_DIR}/example.cpp" CONTENT "${CMAKE_MATCH_1}" @ONLY)
build_consumer("${CMAKE_CURRENT_LIST_DIR}/core" "${WORK_DIR}/build-core" "${header_only};embree;FFTW3;PNG;TBB;ZLIB" -D
               "EXAMPLE=${WORK_DIR}/example.cpp")
execute_process(COMMAND "${WORK_DIR}/build-core/example" OUTPUT_VARIABLE output WORKING_DIRECTORY
                        "${CMAKE_CURRENT_LIST_DIR}/../.." COMMAND_ERROR_IS_FATAL ANY)
if(NOT output STREQUAL shown)
  message(FATAL_ERROR "The example of the README printed: ${output}")
endif()
execute_process(COMMAND ldd "${WORK_DIR}/build-core/example" OUTPUT_VARIABLE loaded COMMAND_ERROR_IS_FATAL ANY)
if(loaded MATCHES "lib(embree|fftw|png|tbb|z\\.so)[^ ]*" OR NOT loaded MATCHES "libc\\.so")
  message(FATAL_ERROR "A program of the core alone loads ${CMAKE_MATCH_0}: ${loaded}")
endif()

# Files that tell the version to other tools.
foreach(file IN ITEMS vcpkg.json CITATION.cff packaging/vcpkg/ports/brdfplot/vcpkg.json packaging/homebrew/brdfplot.rb)
  file(STRINGS "${CMAKE_CURRENT_LIST_DIR}/../../${file}" line REGEX "^[ \"]*version\"?:? \"?[0-9]")
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
  file(STRINGS "${prefix}/include/brdfplot/${header}" third_party REGEX "^ *# *include *<(nlohmann|boost|Eigen|CLI|embree[34]|tbb)/")
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
