# stb
# Version: 2.27 of stb_image; any recent one
# Licence: public domain or MIT
# Why: reads and writes images with one function each; the package is a built library, so nobody defines its implementation.
nuno_find_module(stb "stb" libstb-dev)
