# CGAL
# Version: 5.5.1; 5.2 or newer
# Licence: GPL-3.0 or later (the parts used), which is why only a separate test program has it
# Why: exact predicates and box intersection for the checker of exported meshes (tests/exact), which shares no code with
# nuno.
find_path(NUNO_CGAL_INCLUDE CGAL/box_intersection_d.h)
mark_as_advanced(NUNO_CGAL_INCLUDE)
if(NUNO_CGAL_INCLUDE AND TARGET third_party::gmp)
    add_library(third_party_cgal INTERFACE)
    target_include_directories(third_party_cgal SYSTEM INTERFACE ${NUNO_CGAL_INCLUDE})
    # Interval arithmetic changes the rounding mode, which the compiler must not reorder.
    target_compile_options(third_party_cgal INTERFACE -frounding-math)
    target_link_libraries(third_party_cgal INTERFACE third_party::gmp mpfr)
    add_library(third_party::cgal ALIAS third_party_cgal)
else()
    nuno_missing("cgal" libcgal-dev)
endif()
