# The batch kernels: one source, loops.hpp, compiled once per instruction set and chosen at run time.
set(kernels_dir "${CMAKE_CURRENT_LIST_DIR}")
target_sources(brdfplot-core PRIVATE "${kernels_dir}/kernels.cpp" "${kernels_dir}/kernels_baseline.cpp")

# -O3 in every build type: these loops are what is tested, and at -O0 inline functions would be emitted, compiled for
# one instruction set, under names that all of them share.
set(kernel_flags -O3 -fno-math-errno -fno-trapping-math -ffp-contract=off)
if(BRDFPLOT_SANITIZE AND CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  list(APPEND kernel_flags -Wno-pass-failed) # loops that are instrumented are not vectorized
endif()
set_source_files_properties("${kernels_dir}/kernels_baseline.cpp" PROPERTIES COMPILE_OPTIONS "${kernel_flags}")

if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
  target_sources(brdfplot-core PRIVATE "${kernels_dir}/kernels_avx2.cpp" "${kernels_dir}/kernels_avx512.cpp")
  set_source_files_properties("${kernels_dir}/kernels_avx2.cpp" PROPERTIES COMPILE_OPTIONS
                                                                           "${kernel_flags};-mavx2;-mfma")
  set_source_files_properties(
    "${kernels_dir}/kernels_avx512.cpp"
    PROPERTIES COMPILE_OPTIONS
               "${kernel_flags};-mavx2;-mfma;-mavx512f;-mavx512dq;-mavx512vl;-mprefer-vector-width=512")
  set_source_files_properties("${kernels_dir}/kernels.cpp" PROPERTIES COMPILE_DEFINITIONS BRDFPLOT_KERNELS_X86)
endif()
