# Run by CPack on the files to be packed: Debian's names for licence and changelogs, and what Debian wants compressed.
cmake_minimum_required(VERSION 3.25)
set(share ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr/share)
set(documents ${share}/doc/pellucida)

file(RENAME ${documents}/LICENSE ${documents}/copyright)
file(RENAME ${documents}/CHANGELOG.md ${documents}/changelog)
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
set(version ${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})
file(WRITE ${documents}/changelog.Debian "pellucida (${version}) bookworm; urgency=medium

  * Release ${CPACK_PACKAGE_VERSION}; see changelog.gz for what is new.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
execute_process(
  COMMAND gzip -9 -n -f ${documents}/changelog ${documents}/changelog.Debian ${share}/man/man1/pellucida.1
  COMMAND_ERROR_IS_FATAL ANY)
