# GMP
# Version: 6.2.1; 6.0
# Licence: LGPL-3.0 or GPL-2.0
# Why: rational numbers of any length for the oracle that the continuous collision tests are held to; tests only. Only its
# newest versions have pkg-config modules everywhere.
find_path(NUNO_GMP_INCLUDE gmpxx.h)
find_library(NUNO_GMP_LIBRARY gmp)
find_library(NUNO_GMPXX_LIBRARY gmpxx)
mark_as_advanced(NUNO_GMP_INCLUDE NUNO_GMP_LIBRARY NUNO_GMPXX_LIBRARY)
if(NUNO_GMP_INCLUDE AND NUNO_GMP_LIBRARY AND NUNO_GMPXX_LIBRARY)
    add_library(third_party_gmp INTERFACE)
    target_include_directories(third_party_gmp SYSTEM INTERFACE ${NUNO_GMP_INCLUDE})
    target_link_libraries(third_party_gmp INTERFACE ${NUNO_GMPXX_LIBRARY} ${NUNO_GMP_LIBRARY})
    add_library(third_party::gmp ALIAS third_party_gmp)
else()
    nuno_missing("gmp" libgmp-dev)
endif()
