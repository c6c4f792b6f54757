# Embree
# Version: 3.13; 3.x
# Licence: Apache-2.0
# Why: its self-query beside nuno's in bench/tree_bench. Left out of it where Embree is missing.
find_package(embree 3 QUIET)
if(embree_FOUND)
    add_library(third_party::embree ALIAS embree)
endif()
