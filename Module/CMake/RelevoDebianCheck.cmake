# CPack reads this file in builds that are not for /usr.
if (CPACK_GENERATOR STREQUAL "DEB")
  message(FATAL_ERROR "This build does not have the folders of Debian. Run bash Module/package.sh, "
    "or configure a build with -DCMAKE_INSTALL_PREFIX=/usr on Debian.")
endif ()
