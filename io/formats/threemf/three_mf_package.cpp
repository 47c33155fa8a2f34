#include "io/formats/threemf/three_mf_package.h"

#include "io/files/lower_case.h"
#include "io/formats/threemf/three_mf_model.h"
#include "io/formats/threemf/zip_archive.h"

#include <algorithm>
#include <set>
#include <string_view>

namespace knead {

namespace {

constexpr std::string_view relationsName = "_rels/.rels";
constexpr std::string_view rootRelation = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";
constexpr std::string_view usualRoot = "3D/3dmodel.model";

/// Finds the file that the relations of an archive call its model.
class RootListener final : public XmlListener {
public:
    void begin(const XmlElement& element) override
    {
        if (root.empty() && element.name == "Relationship" && element.attribute("Type") == rootRelation)
            root = element.attribute("Target").value_or("");
    }
    void end() override {}

    std::string root;
};

class PackageReader {
public:
    PackageReader(const std::string& path, TaskControl& control)
        : m_path(path)
        , m_control(control)
        , m_files(zipEntries(path).value_or(std::vector<ZipEntry>()))
    {
        for (const ZipEntry& file : m_files)
            m_size += file.size;
    }

    ThreeMfPackage run()
    {
        RootListener relations;
        if (const ZipEntry* file = find(relationsName))
            read(*file, relations);
        readModel(threeMfFile(relations.root.empty() ? usualRoot : relations.root), true);
        // Models that others name may name others.
        for (std::set<std::string> named = unread(); !named.empty(); named = unread())
            for (const std::string& model : named)
                readModel(model, false);
        return std::move(m_package);
    }

private:
    const ZipEntry* find(std::string_view name) const
    {
        const auto found =
            std::ranges::find_if(m_files, [&](const ZipEntry& file) { return threeMfFile(file.name) == name; });
        return found == m_files.end() ? nullptr : &*found;
    }

    void readModel(const std::string& name, bool isRoot)
    {
        m_read.insert(name);
        const ZipEntry* file = find(name);
        if (file == nullptr)
            throw DamagedThreeMf();
        ThreeMfModelListener listener(name, isRoot, m_package);
        read(*file, listener);
    }

    void read(const ZipEntry& file, XmlListener& listener)
    {
        XmlEvents events(listener);
        unpack(m_path, file, [&](std::string_view bytes) {
            m_control.throwIfCancelled();
            events.take(bytes);
            m_unpacked += static_cast<double>(bytes.size());
            m_control.report(std::min(m_unpacked / static_cast<double>(m_size + 1), 1.0), "reading the file");
        });
        events.finish();
    }

    std::set<std::string> unread() const
    {
        std::set<std::string> named;
        const auto add = [&](const std::vector<ThreeMfPlaced>& all) {
            for (const ThreeMfPlaced& one : all)
                if (!m_read.contains(one.object.first))
                    named.insert(one.object.first);
        };
        add(m_package.build);
        for (const auto& [id, object] : m_package.objects)
            add(object.components);
        return named;
    }

    const std::string& m_path;
    TaskControl& m_control;
    std::vector<ZipEntry> m_files;
    std::uint64_t m_size = 0; ///< of all of them
    double m_unpacked = 0;
    ThreeMfPackage m_package;
    std::set<std::string> m_read; ///< models
};

} // namespace

std::string threeMfFile(std::string_view name)
{
    return lowerCase(std::string(name.substr(name.starts_with('/') ? 1 : 0)));
}

const ThreeMfObject& ThreeMfPackage::object(const ThreeMfId& id) const
{
    const auto found = objects.find(id);
    if (found == objects.end())
        throw DamagedThreeMf();
    return found->second;
}

ThreeMfPackage readThreeMfPackage(const std::string& path, TaskControl& control)
{
    try {
        return PackageReader(path, control).run();
    } catch (const DamagedZip&) {
        throw DamagedThreeMf();
    } catch (const BrokenXml&) {
        throw DamagedThreeMf();
    }
}

} // namespace knead
