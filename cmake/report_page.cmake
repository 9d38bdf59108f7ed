# The script of the report page: npm fetches what it imports (into the build folder, once for a lock file), esbuild makes
# one file of it, and script and style become a source of the room `report`.
find_program(NODE_PROGRAM node DOC "runs esbuild, which bundles the report page")
find_program(NPM_PROGRAM npm DOC "fetches the libraries of the report page")
if(NOT NODE_PROGRAM OR NOT NPM_PROGRAM)
  message(FATAL_ERROR "node and npm are needed to bundle the report page (Debian: apt-get install nodejs npm)")
endif()

# millwright_npm_packages(<sources> <folder> <what for>): the packages of the lock file in <sources> are in
# <folder>/node_modules once <folder>/npm.stamp is there.
function(millwright_npm_packages sources folder what)
  file(MAKE_DIRECTORY ${folder})
  add_custom_command(OUTPUT ${folder}/npm.stamp
    COMMAND ${CMAKE_COMMAND} -E copy ${sources}/package.json ${sources}/package-lock.json ${folder}
    COMMAND ${NPM_PROGRAM} ci --ignore-scripts --no-audit --no-fund --prefer-offline --loglevel=error
    COMMAND ${CMAKE_COMMAND} -E touch ${folder}/npm.stamp
    DEPENDS ${sources}/package.json ${sources}/package-lock.json
    WORKING_DIRECTORY ${folder}
    COMMENT "npm ci (${what})" VERBATIM)
endfunction()

set(page_sources ${PROJECT_SOURCE_DIR}/src/report/page)
set(page_build ${PROJECT_BINARY_DIR}/report_page)

millwright_npm_packages(${page_sources} ${page_build} "report page")

file(GLOB page_scripts CONFIGURE_DEPENDS ${page_sources}/*.js)
set(licence "/* With Observable Plot and D3, copyright Observable, Inc. and Mike Bostock, ISC licence. */")
add_custom_command(OUTPUT ${page_build}/page.js
  COMMAND ${CMAKE_COMMAND} -E env NODE_PATH=${page_build}/node_modules
    ${NODE_PROGRAM} ${page_build}/node_modules/esbuild/bin/esbuild ${page_sources}/main.js --bundle --minify --format=iife
    --target=es2020 --charset=ascii --legal-comments=none --log-level=warning "--banner:js=${licence}"
    --outfile=${page_build}/page.js
  DEPENDS ${page_build}/npm.stamp ${page_scripts}
  COMMENT "Bundling the report page" VERBATIM)

add_custom_command(OUTPUT ${page_build}/page_assets.cpp
  COMMAND ${CMAKE_COMMAND} -D LITERALS=${PROJECT_SOURCE_DIR}/cmake/text_literals.cmake -D STYLE=${page_sources}/style.css
    -D SCRIPT=${page_build}/page.js -D SOURCES=${PROJECT_SOURCE_DIR}/src/mechanics/sources.bib -D OUTPUT=${page_build}/page_assets.cpp -P ${page_sources}/embed.cmake
  DEPENDS ${page_build}/page.js ${page_sources}/style.css ${PROJECT_SOURCE_DIR}/src/mechanics/sources.bib ${page_sources}/embed.cmake
    ${PROJECT_SOURCE_DIR}/cmake/text_literals.cmake
  COMMENT "Embedding the report page" VERBATIM)

target_sources(millwright_report PRIVATE ${page_build}/page_assets.cpp)
