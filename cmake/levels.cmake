# The blocks, which are compiled once for each level of instructions that the compiler offers; `chasles_run` takes the
# best that the machine has. The levels and their numbers are those of generated/c/src/batches.h.
include(CheckCCompilerFlag)

# Each adds itself to the library `library`: its own sources, the blocks of all levels, and how many levels there are.
function(chasles_add_sources library)
    target_sources(${library} PRIVATE ${chasles_sources} ${chasles_level_objects})
    target_compile_options(${library} PRIVATE ${chasles_compile_options})
    target_compile_definitions(${library} PRIVATE CHASLES_LEVELS=${chasles_levels})
endfunction()

set_source_files_properties(
    "${PROJECT_SOURCE_DIR}/generated/c/src/trigonometry_blocks.c"
    PROPERTIES COMPILE_OPTIONS "${chasles_contracted}"
)

set(chasles_levels 0)
set(chasles_level_objects)
foreach(target own x86-64-v3 x86-64-v4)
    set(chasles_has_own ON)
    if(NOT target STREQUAL "own")
        if(NOT CMAKE_C_COMPILER_ID MATCHES "^(GNU|Clang)$" OR NOT CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
            break()
        endif()
        if(CMAKE_C_COMPILER_ID STREQUAL "GNU" AND CMAKE_C_COMPILER_VERSION VERSION_LESS 12)
            break()
        endif()
        if(CMAKE_C_COMPILER_FRONTEND_VARIANT STREQUAL "MSVC")
            # What asks the processor for its instructions is in Clang's own library, which is not linked there.
            break()
        endif()
        check_c_compiler_flag(-march=${target} chasles_has_${target})
    endif()
    if(NOT chasles_has_${target})
        break()
    endif()
    set(level chasles_blocks_${target})
    add_library(${level} OBJECT ${chasles_block_sources})
    set_target_properties(${level} PROPERTIES C_STANDARD 99 C_VISIBILITY_PRESET hidden POSITION_INDEPENDENT_CODE ON)
    target_compile_options(${level} PRIVATE ${chasles_block_options} $<$<NOT:$<STREQUAL:${target},own>>:-march=${target}>)
    target_compile_definitions(${level} PRIVATE CHASLES_LEVEL=${chasles_levels})
    target_include_directories(${level} PRIVATE "${PROJECT_SOURCE_DIR}/generated/c/include")
    list(APPEND chasles_level_objects "$<TARGET_OBJECTS:${level}>")
    math(EXPR chasles_levels "${chasles_levels} + 1")
endforeach()
