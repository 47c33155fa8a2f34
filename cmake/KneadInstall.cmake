# What a person needs, by GNUInstallDirs: cmake --install BUILD --prefix FOLDER, after building the target knead_shipped.
# Icons and what desktops read: resources/desktop.
add_custom_target(knead_shipped DEPENDS knead knead_icons)
install(TARGETS knead)
if(TARGET knead_cad_worker)
    add_dependencies(knead_shipped knead_cad_worker)
    install(TARGETS knead_cad_worker DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/knead)
endif()
if(TARGET knead_python)
    add_dependencies(knead_shipped knead_python)
endif()

set(data ${CMAKE_INSTALL_DATADIR}/knead)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/resources/examples DESTINATION ${data} PATTERN generator EXCLUDE
    PATTERN library EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/resources/handbook ${PROJECT_SOURCE_DIR}/resources/materials DESTINATION ${data})
install(FILES ${PROJECT_SOURCE_DIR}/resources/recipe.schema.json DESTINATION ${data})
# An add-on for FreeCAD, to be linked into its folder Mod; its icon is a link here.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/resources/freecad DESTINATION ${data} PATTERN __pycache__ EXCLUDE PATTERN knead.svg EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/resources/icons/knead.svg DESTINATION ${data}/freecad/Knead)

# Manual pages and completions come from the command line itself; what is shipped of texts is packed as Debian packs it.
find_program(KNEAD_GZIP gzip REQUIRED)
set(zsh site-functions)
if(EXISTS /etc/debian_version)
    set(zsh vendor-completions)
endif()
set(KNEAD_ZSH_COMPLETIONS ${CMAKE_INSTALL_DATADIR}/zsh/${zsh} CACHE STRING "Where zsh looks for completions")
set(described ${PROJECT_BINARY_DIR}/described)
install(CODE "
    file(REMOVE_RECURSE \"${described}\")
    execute_process(COMMAND \"$<TARGET_FILE:knead>\" describe \"${described}\" COMMAND_ERROR_IS_FATAL ANY)
    configure_file(\"${PROJECT_SOURCE_DIR}/CHANGELOG.md\" \"${described}/doc/changelog\" COPYONLY)
    file(GLOB texts \"${described}/man/*.1\" \"${described}/doc/*\")
    execute_process(COMMAND \"${KNEAD_GZIP}\" -9n \${texts} COMMAND_ERROR_IS_FATAL ANY)")
install(DIRECTORY ${described}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(DIRECTORY ${described}/doc/ DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES ${described}/completions/knead DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${described}/completions/_knead DESTINATION ${KNEAD_ZSH_COMPLETIONS})
install(FILES ${described}/completions/knead.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
