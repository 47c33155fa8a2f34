#pragma once

#include "io/formats/threemf/three_mf_package.h"
#include "io/formats/xml_events.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace knead {

/// Puts what stands in one model of a 3MF into a package.
class ThreeMfModelListener final : public XmlListener {
public:
    /// @param file that the text is of, by threeMfFile()
    /// @param isRoot whether its unit and its build are those of the package, which outlives this
    ThreeMfModelListener(const std::string& file, bool isRoot, ThreeMfPackage& package);

    void space(std::string_view prefix, std::string_view address) override;
    void begin(const XmlElement& element) override; ///< @throws DamagedThreeMf
    void end() override;

private:
    enum class Place {
        document,
        model,
        resources,
        colors,
        object,
        mesh,
        vertices,
        triangles,
        components,
        build,
        inner
    };
    using Colors = std::vector<std::optional<Color>>;

    Place beginAt(Place parent, const XmlElement& element);
    void beginModel(const XmlElement& element);
    void noteExtensions(std::string_view prefixes);
    Place beginResource(const XmlElement& element);
    void beginObject(const XmlElement& element);
    void addColor(const XmlElement& element);
    void addVertex(const XmlElement& element);
    void addTriangle(const XmlElement& element);
    void addComponent(const XmlElement& element);
    void addItem(const XmlElement& element);
    void endObject();
    ThreeMfPlaced placed(const XmlElement& element) const;
    std::optional<Color> color(std::uint32_t group, std::optional<std::uint32_t> index);

    const std::string m_file;
    const bool m_isRoot;
    ThreeMfPackage& m_package;
    std::vector<Place> m_places{Place::document};
    std::map<std::string, std::string, std::less<>> m_spaces; ///< addresses by prefixes, of the whole model
    std::map<std::uint32_t, Colors> m_groups;                 ///< what is no color has none
    Colors* m_group = nullptr;                                ///< that is being read
    ThreeMfObject* m_object = nullptr;
    std::optional<std::uint32_t> m_groupOfObject;
    std::optional<Color> m_colorOfObject;
};

} // namespace knead
