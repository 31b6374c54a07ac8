# The library, of the source tree in which this port stands, as an overlay port:
#
#   vcpkg install brdfplot --overlay-ports=packaging/vcpkg/ports
vcpkg_check_linkage(ONLY_STATIC_LIBRARY)
get_filename_component(SOURCE_PATH "${CURRENT_PORT_DIR}/../../../.." ABSOLUTE)

vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS -DBRDFPLOT_BUILD_TESTS=OFF -DBRDFPLOT_BUILD_BENCH=OFF -DBRDFPLOT_BUILD_PYTHON=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/brdfplot)

# The command finds its configs beside itself, which a tool's folder of vcpkg is not: the port is the library alone.
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/bin" "${CURRENT_PACKAGES_DIR}/debug/bin"
     "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
