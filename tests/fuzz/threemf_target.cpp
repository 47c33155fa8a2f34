#include "fuzz/scratch_file.h"
#include "fuzz/targets.h"
#include "io/files/byte_sink.h"
#include "io/formats/threemf/three_mf_reader.h"
#include "io/formats/threemf/zip_writer.h"
#include "support/mesh_containers.h"

namespace knead::fuzz {

namespace {

std::string modelWith(const std::string& resources, const std::string& build)
{
    return "<?xml version=\"1.0\"?><model unit=\"inch\" "
           "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
           "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\" "
           "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\"><resources>" +
           resources + "</resources><build>" + build + "</build></model>";
}

/// A tetrahedron, placed twice by a part of two components; with colors of both kinds.
std::vector<std::string> modelTexts()
{
    const std::string mesh =
        "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"60\" y=\"0\" z=\"0\"/>"
        "<vertex x=\"0\" y=\"30\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"2e1\"/></vertices><triangles>"
        "<triangle v1=\"0\" v2=\"2\" v3=\"1\" pid=\"5\" p1=\"1\"/><triangle v1=\"0\" v2=\"1\" v3=\"3\"/>"
        "<triangle v1=\"0\" v2=\"3\" v3=\"2\"/><triangle v1=\"1\" v2=\"2\" v3=\"3\"/></triangles></mesh>";
    const std::string colors = "<basematerials id=\"4\"><base name=\"a\" displaycolor=\"#FF8000\"/></basematerials>"
                               "<m:colorgroup id=\"5\"><m:color color=\"#00FF00\"/><m:color color=\"#0000FF80\"/>"
                               "</m:colorgroup>";
    const std::string object = "<object id=\"1\" name=\"lid &amp; box\" pid=\"4\" pindex=\"0\" type=\"model\">" + mesh +
                               "</object><object id=\"2\" type=\"support\">" + mesh + "</object>";
    const std::string together =
        "<object id=\"7\"><components><component objectid=\"1\" p:path=\"/3D/3dmodel.model\"/>"
        "<component objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 100 0 0\"/></components></object>";
    return {modelWith(colors + object + together, "<item objectid=\"7\"/><item objectid=\"2\"/>"),
            modelWith("<object id=\"1\">" + mesh + "</object>",
                      "<item objectid=\"1\" transform=\"0 1 0 -1 0 0 0 0 1 1 2 3\"/>")};
}

class StringSink final : public ByteSink {
public:
    void write(std::string_view bytes) override { content += bytes; }
    std::string content;
};

std::string compressedArchive()
{
    StringSink sink;
    ZipWriter zip(sink);
    zip.beginFile("3D/3dmodel.model");
    zip.write(modelTexts().front());
    zip.finish();
    return sink.content;
}

std::vector<std::string> archives()
{
    std::vector<std::string> all{compressedArchive()};
    for (const std::string& text : modelTexts())
        all.push_back(threeMfOf(text));
    return all;
}

bool readArchive(std::string_view bytes)
{
    static const ScratchFile file("a.3mf");
    const std::string path = file.with(bytes);
    return isTaken([&] { readThreeMf(path, {}, TaskControl::none()); });
}

bool readThreeMfText(std::string_view bytes)
{
    return readArchive(threeMfOf(std::string(bytes)));
}

} // namespace

Target zipTarget()
{
    return {archives, readArchive};
}

Target threemfTarget()
{
    return {modelTexts, readThreeMfText};
}

} // namespace knead::fuzz
