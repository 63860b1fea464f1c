# Follows Debian's policy if Relevo is installed into /usr on Debian or Ubuntu. Module/package.sh
# configures such a build. GNUInstallDirs chooses lib/<triplet> for it.

set(relevo_debian_layout OFF)
if (relevo_is_whole AND CMAKE_INSTALL_PREFIX STREQUAL "/usr" AND EXISTS /etc/debian_version)
  set(relevo_debian_layout ON)
  set(CMAKE_INSTALL_DOCDIR "share/doc/relevo" CACHE PATH "Documentation")
  set(RELEVO_PYTHON_DESTINATION "lib/python3/dist-packages" CACHE STRING
    "Folder of Python packages, relative to the prefix")
  # The loader finds libraries in /usr. The plugin for ParaView has its libraries beside it.
  if (NOT RELEVO_BUILD_PARAVIEW)
    set(CMAKE_SKIP_INSTALL_RPATH ON)
  endif ()
endif ()
