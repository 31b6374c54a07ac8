# The Debian packages: brdfplot, the command with the built-in configs, and libbrdfplot-dev, the static library.
#
#   scripts/package
#
# DEBFULLNAME and DEBEMAIL name the maintainer, as they do for Debian's own tools.
find_program(GZIP gzip)
if(NOT GZIP)
  message(STATUS "No gzip: no Debian packages")
  return()
endif()

set(debian_dir "${PROJECT_BINARY_DIR}/debian")
set(debian_revision 1)
set(maintainer_name "$ENV{DEBFULLNAME}")
set(maintainer_address "$ENV{DEBEMAIL}")
if(NOT maintainer_name)
  set(maintainer_name "The brdfplot authors")
endif()
if(NOT maintainer_address)
  set(maintainer_address "authors@brdfplot.example")
endif()
set(maintainer "${maintainer_name} <${maintainer_address}>")

# What every Debian package has in its documentation: copyright, the changelog of the package and that of the project.
file(STRINGS "${PROJECT_SOURCE_DIR}/LICENSE" license_lines)
set(license_text)
set(copyright_holder)
foreach(line IN LISTS license_lines)
  if(line MATCHES "^Copyright \\(c\\) (.+)$")
    set(copyright_holder "${CMAKE_MATCH_1}")
  elseif(line STREQUAL "")
    string(APPEND license_text " .\n")
  elseif(NOT line MATCHES "^MIT License$")
    string(APPEND license_text " ${line}\n")
  endif()
endforeach()
string(REGEX REPLACE "^( \\.\n)+" "" license_text "${license_text}")
configure_file("${CMAKE_CURRENT_LIST_DIR}/copyright.in" "${debian_dir}/copyright" @ONLY)
string(TIMESTAMP debian_date "%a, %d %b %Y %H:%M:%S +0000" UTC) # SOURCE_DATE_EPOCH sets it
configure_file("${CMAKE_CURRENT_LIST_DIR}/changelog.in" "${debian_dir}/changelog.Debian" @ONLY)
configure_file("${PROJECT_SOURCE_DIR}/CHANGELOG.md" "${debian_dir}/changelog" COPYONLY)
execute_process(COMMAND "${GZIP}" -9nf "${debian_dir}/changelog.Debian" "${debian_dir}/changelog" COMMAND_ERROR_IS_FATAL ANY)
foreach(package_and_component IN ITEMS "brdfplot debian-runtime" "libbrdfplot-dev debian-development")
  separate_arguments(package_and_component)
  list(GET package_and_component 0 package)
  list(GET package_and_component 1 component)
  install(
    FILES "${debian_dir}/copyright" "${debian_dir}/changelog.gz" "${debian_dir}/changelog.Debian.gz"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${package}"
    COMPONENT ${component} EXCLUDE_FROM_ALL)
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME brdfplot)
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_BINARY_DIR}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
                                                WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE ${debian_revision})
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${maintainer}")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_COMPONENTS_ALL runtime debian-runtime development debian-development)
set(CPACK_DEBIAN_COMMAND_PACKAGE_NAME brdfplot)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_COMMAND_PACKAGE_RECOMMENDS librsvg2-bin) # PNG and PDF
set(CPACK_DEBIAN_COMMAND_DESCRIPTION
    "brdfplot reads materials as JSON and computes their masking, distributions
of normals, reflectance and integrals, with an error estimate behind every
integral. It writes CSV, SVG, HTML reports, tables for renderers and code for
shaders.")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libbrdfplot-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
# What brdfplotConfig.cmake looks for.
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "libembree-dev, libfftw3-dev, libmuparser-dev, libpng-dev, libtbb-dev, zlib1g-dev")
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION
    "This is the library behind brdfplot, static, with its headers: models,
quantities, integrals, sampling, simulation on generated surfaces, and figures.
find_package(brdfplot) of CMake finds it.")

include(CPack)
cpack_add_component_group(command)
cpack_add_component_group(library)
cpack_add_component(runtime GROUP command)
cpack_add_component(debian-runtime GROUP command)
cpack_add_component(development GROUP library)
cpack_add_component(debian-development GROUP library)
