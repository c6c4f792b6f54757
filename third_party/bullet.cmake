# Bullet
# Version: 3.24; 3.0 or newer
# Licence: zlib
# Why: a soft body of a packaged engine beside nuno's in bench/hang_bench. Left out of it where Bullet is missing.
if(PKG_CONFIG_FOUND)
    pkg_check_modules(bullet QUIET IMPORTED_TARGET GLOBAL "bullet>=3.0")
endif()
if(bullet_FOUND)
    add_library(third_party::bullet ALIAS PkgConfig::bullet)
endif()
