# knead_occt, what of OpenCASCADE is needed, and KNEAD_OCCT_VERSION; for Knead itself and for those who build on it. Its version file
# refuses 7.6.3 when 7.6 is asked for, and its COMPONENTS fail, so who includes this looks at both.
find_package(OpenCASCADE QUIET NO_MODULE)
set(KNEAD_OCCT_VERSION ${OpenCASCADE_MAJOR_VERSION}.${OpenCASCADE_MINOR_VERSION})
if(OpenCASCADE_FOUND AND NOT TARGET knead_occt)
    set(knead_occt_toolkits TKernel TKMath TKG2d TKG3d TKGeomBase TKBRep TKGeomAlgo TKTopAlgo TKShHealing TKMesh TKPrim
        TKBO TKBool TKFillet TKOffset TKCDF TKLCAF TKCAF TKXCAF TKXSBase)
    if(KNEAD_OCCT_VERSION VERSION_LESS 7.8)
        list(APPEND knead_occt_toolkits TKSTEP TKSTEPBase TKSTEPAttr TKSTEP209 TKXDESTEP TKIGES TKXDEIGES)
    else()
        list(APPEND knead_occt_toolkits TKDESTEP TKDEIGES)
    endif()
    add_library(knead_occt INTERFACE IMPORTED)
    target_include_directories(knead_occt SYSTEM INTERFACE ${OpenCASCADE_INCLUDE_DIR})
    target_link_libraries(knead_occt INTERFACE ${knead_occt_toolkits})
endif()
