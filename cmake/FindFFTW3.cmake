# FFTW in double precision as FFTW3::fftw3: its own CMake package is not in Debian's.
find_path(FFTW3_INCLUDE_DIR fftw3.h DOC "Folder of fftw3.h")
find_library(FFTW3_LIBRARY fftw3 DOC "FFTW in double precision")
mark_as_advanced(FFTW3_INCLUDE_DIR FFTW3_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(FFTW3 REQUIRED_VARS FFTW3_LIBRARY FFTW3_INCLUDE_DIR)

if(FFTW3_FOUND AND NOT TARGET FFTW3::fftw3)
  add_library(FFTW3::fftw3 UNKNOWN IMPORTED)
  set_target_properties(FFTW3::fftw3 PROPERTIES IMPORTED_LOCATION "${FFTW3_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES
                                                                                     "${FFTW3_INCLUDE_DIR}")
endif()
