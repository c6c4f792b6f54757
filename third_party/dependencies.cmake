# Finds every package nuno links and gives each the target name third_party::<name>.
# One file per package beside this one; all that is missing is reported together, with the one command that installs it.
find_package(PkgConfig QUIET)
set(NUNO_MISSING_NAMES "")
set(NUNO_MISSING_PACKAGES "")

# Notes that `name` was not found and that the system package `package` brings it.
macro(nuno_missing name package)
    list(APPEND NUNO_MISSING_NAMES "${name}")
    list(APPEND NUNO_MISSING_PACKAGES "${package}")
endmacro()

# Makes third_party::<name> from the pkg-config module `module` ("glfw3>=3.3"), shipped by the system package `package`.
macro(nuno_find_module name module package)
    if(PKG_CONFIG_FOUND)
        pkg_check_modules(${name} QUIET IMPORTED_TARGET GLOBAL "${module}")
    endif()
    if(${name}_FOUND)
        add_library(third_party::${name} ALIAS PkgConfig::${name})
    else()
        nuno_missing("${name} (${module})" ${package})
    endif()
endmacro()

if(NOT PKG_CONFIG_FOUND)
    nuno_missing("pkg-config" pkg-config)
endif()

set(NUNO_DEPENDENCIES
    cli11 egl fmt glad glfw glm imgui libpng nlohmann_json stb threads tomlplusplus)
if(NUNO_TESTS)
    list(APPEND NUNO_DEPENDENCIES gmp cgal googletest valijson)
endif()
if(NUNO_BENCH)
    list(APPEND NUNO_DEPENDENCIES benchmark bullet embree)
endif()
foreach(dependency IN LISTS NUNO_DEPENDENCIES)
    include(${CMAKE_CURRENT_LIST_DIR}/${dependency}.cmake)
endforeach()

if(NUNO_MISSING_NAMES)
    list(JOIN NUNO_MISSING_NAMES ", " missing)
    list(REMOVE_DUPLICATES NUNO_MISSING_PACKAGES)
    list(JOIN NUNO_MISSING_PACKAGES " " packages)
    message(FATAL_ERROR "Not found: ${missing}.\nOn Debian or Ubuntu this installs what is missing:\n"
        "    apt-get install --no-install-recommends ${packages}\n"
        "Elsewhere, install the packages of the same names; third_party/README.md lists versions.")
endif()
