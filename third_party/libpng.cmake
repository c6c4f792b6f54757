# libpng
# Version: 1.6.39; 1.6 or newer
# Licence: libpng-2.0
# Why: writes rendered frames several times faster and smaller than stb does.
nuno_find_module(libpng "libpng>=1.6" libpng-dev)
