# chasles._kernels: NumPy generalised ufuncs over the C kernels.

# The stable ABI where the interpreter has one; a free-threaded interpreter gets a build of its own.
find_package(Python REQUIRED COMPONENTS Interpreter Development.Module NumPy ${SKBUILD_SABI_COMPONENT})
if(SKBUILD_SABI_VERSION)
    set(stable_abi USE_SABI ${SKBUILD_SABI_VERSION})
endif()

file(GLOB gufunc_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/generated/gufunc/*.c")
python_add_library(_kernels MODULE WITH_SOABI ${stable_abi} ${gufunc_sources})
chasles_add_sources(_kernels)
set_target_properties(_kernels PROPERTIES C_STANDARD 11 C_VISIBILITY_PRESET hidden)
target_compile_definitions(
    _kernels PRIVATE NPY_NO_DEPRECATED_API=NPY_2_0_API_VERSION NPY_TARGET_VERSION=NPY_2_0_API_VERSION
)
target_include_directories(
    _kernels PRIVATE "${PROJECT_SOURCE_DIR}/generated/c/include" "${PROJECT_SOURCE_DIR}/generated/c/src"
)
target_link_libraries(_kernels PRIVATE Python::NumPy $<$<PLATFORM_ID:Linux>:m>)
install(TARGETS _kernels DESTINATION chasles)
