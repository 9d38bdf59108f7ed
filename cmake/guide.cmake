# The guide as HTML, the manual pages and the JSON Schema of problem files: made with the optimised program from its own
# texts, installed beside it.
set(guide_sources ${PROJECT_SOURCE_DIR}/src/guide)
set(guide_build ${PROJECT_BINARY_DIR}/guide)
millwright_npm_packages(${guide_sources} ${guide_build} "guide")

file(GLOB guide_files CONFIGURE_DEPENDS ${guide_sources}/*.md ${guide_sources}/*.cjs ${guide_sources}/*.css)
add_custom_command(OUTPUT ${guide_build}/guide.stamp
  COMMAND ${CMAKE_COMMAND} -E env NODE_PATH=${guide_build}/node_modules
    ${NODE_PROGRAM} ${guide_sources}/build.cjs $<TARGET_FILE:millwright> ${PROJECT_SOURCE_DIR} ${guide_build}/html
  COMMAND ${NODE_PROGRAM} ${guide_sources}/man.cjs $<TARGET_FILE:millwright> ${guide_build}/man1
  COMMAND $<TARGET_FILE:millwright> schema > ${guide_build}/millwright.schema.json
  COMMAND ${CMAKE_COMMAND} -E touch ${guide_build}/guide.stamp
  DEPENDS ${guide_build}/npm.stamp ${guide_files} millwright
  COMMENT "Guide, manual pages, schema" VERBATIM)
add_custom_target(guide ALL DEPENDS ${guide_build}/guide.stamp)

install(DIRECTORY ${guide_build}/html/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/guide OPTIONAL)
install(DIRECTORY ${guide_build}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR} OPTIONAL)
install(FILES ${guide_build}/millwright.schema.json DESTINATION ${CMAKE_INSTALL_DATADIR}/millwright OPTIONAL)
