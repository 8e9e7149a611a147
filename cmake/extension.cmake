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

# What knows no kernel, for kernels compiled later (src/chasles/compiling/compiler.py): objects, in a folder called after
# the texts that they are made of.
if(chasles_levels GREATER 1)
    set(chasles_texts)
    foreach(name batches.c trigonometry_blocks.c batches.h vectors.h)
        file(SHA256 "${PROJECT_SOURCE_DIR}/generated/c/src/${name}" hash)
        string(APPEND chasles_texts "${hash}")
    endforeach()
    string(SHA256 chasles_texts "${chasles_texts}")
    set(chasles_objects "chasles/objects/${chasles_texts}")
    install(FILES $<FILTER:$<TARGET_OBJECTS:_kernels>,INCLUDE,/batches> DESTINATION ${chasles_objects} RENAME batches.o)
    set(level 0)
    foreach(target own x86-64-v3 x86-64-v4)
        if(TARGET chasles_blocks_${target})
            install(
                FILES $<FILTER:$<TARGET_OBJECTS:chasles_blocks_${target}>,INCLUDE,/trigonometry_blocks>
                DESTINATION ${chasles_objects}
                RENAME trigonometry_blocks_${level}.o
            )
            math(EXPR level "${level} + 1")
        endif()
    endforeach()
endif()
