# The C library `chasles`: static, or shared with -DBUILD_SHARED_LIBS=ON.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
include(CTest)

add_library(chasles)
chasles_add_sources(chasles)
add_library(chasles::chasles ALIAS chasles)
set_target_properties(
    chasles
    PROPERTIES
        C_STANDARD 99
        C_STANDARD_REQUIRED ON
        POSITION_INDEPENDENT_CODE ON
        WINDOWS_EXPORT_ALL_SYMBOLS ON
        VERSION ${PROJECT_VERSION}
        SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
)
target_include_directories(
    chasles PUBLIC "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/generated/c/include>" "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>"
)
if(UNIX)
    target_link_libraries(chasles PRIVATE m)
endif()

file(GLOB self_test_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/generated/c/test/*.c")
if(BUILD_TESTING AND PROJECT_IS_TOP_LEVEL AND self_test_sources)
    add_executable(chasles_self_test ${self_test_sources})
    set_target_properties(chasles_self_test PROPERTIES C_STANDARD 99 C_STANDARD_REQUIRED ON)
    target_compile_options(chasles_self_test PRIVATE ${chasles_compile_options})
    target_link_libraries(chasles_self_test PRIVATE chasles $<$<BOOL:${UNIX}>:m>)
    add_test(NAME self_test COMMAND chasles_self_test)
endif()

install(TARGETS chasles EXPORT chasles-targets)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/generated/c/include/" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/chasles")
install(EXPORT chasles-targets NAMESPACE chasles:: FILE chasles-config.cmake DESTINATION "${package_dir}")
write_basic_package_version_file(
    "${PROJECT_BINARY_DIR}/chasles-config-version.cmake" COMPATIBILITY SameMinorVersion
)
install(FILES "${PROJECT_BINARY_DIR}/chasles-config-version.cmake" DESTINATION "${package_dir}")

# Paths relative to the .pc file, so that `cmake --install --prefix` and a moved tree stay usable.
file(RELATIVE_PATH prefix_from_pc "${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig" "${CMAKE_INSTALL_PREFIX}")
string(REGEX REPLACE "/$" "" prefix_from_pc "${prefix_from_pc}")
configure_file(cmake/chasles.pc.in chasles.pc @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/chasles.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
