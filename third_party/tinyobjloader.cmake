# tinyobjloader
# Version: 2.0.0rc10; 2.0 or newer
# Licence: MIT
# Why: reads the dialects of Wavefront OBJ that modelling programs write.
nuno_find_module(tinyobjloader "tinyobjloader" libtinyobjloader-dev)
