# GoogleTest
# Version: 1.12.1; 1.11 or newer
# Licence: BSD-3-Clause
# Why: parameterised tests run one body on every backend and method, and CTest lists each test by name.
nuno_find_module(googletest "gmock_main>=1.11" libgmock-dev)
