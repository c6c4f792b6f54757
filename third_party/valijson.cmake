# Valijson
# Version: 1.0; 1.0
# Licence: BSD-2-Clause
# Why: checks the reports against the JSON schema in docs/; tests only. It is headers alone, and has no pkg-config module.
find_path(NUNO_VALIJSON_INCLUDE valijson/schema.hpp)
mark_as_advanced(NUNO_VALIJSON_INCLUDE)
if(NUNO_VALIJSON_INCLUDE)
    add_library(third_party_valijson INTERFACE)
    target_include_directories(third_party_valijson SYSTEM INTERFACE ${NUNO_VALIJSON_INCLUDE})
    # GCC 12 sees an overlap in strings that the headers put together, which cannot be.
    target_compile_options(third_party_valijson INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
    add_library(third_party::valijson ALIAS third_party_valijson)
else()
    nuno_missing("valijson" libvalijson-dev)
endif()
