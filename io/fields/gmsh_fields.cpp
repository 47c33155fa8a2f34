#include "core/model/readable_name.h"
#include "io/fields/byte_numbers.h"
#include "io/fields/field_content.h"
#include "io/fields/gmsh_elements.h"
#include "io/fields/label_map.h"
#include "io/fields/text_scanner.h"

#include <algorithm>
#include <array>

namespace knead {

namespace {

/// Numbers of a Gmsh file, as words or as bytes.
class GmshNumbers {
public:
    GmshNumbers(TextScanner& text, bool isBinary, bool isVersion4)
        : m_text(text)
        , m_isBinary(isBinary)
        , m_isVersion4(isVersion4)
    {
    }

    bool isBinary() const { return m_isBinary; }

    std::int64_t whole() { return m_isBinary ? numberAt<std::int32_t>(m_text.block(4), 0) : m_text.wholeNumber(); }
    /// A tag of a node or an element, or a count of them: 8 bytes since version 4.
    std::int64_t tag()
    {
        if (!m_isBinary)
            return m_text.wholeNumber();
        return m_isVersion4 ? numberAt<std::int64_t>(m_text.block(8), 0) : numberAt<std::int32_t>(m_text.block(4), 0);
    }
    double real() { return m_isBinary ? numberAt<double>(m_text.block(8), 0) : m_text.number(); }
    Vec3 vector()
    {
        const double x = real();
        const double y = real();
        return {x, y, real()};
    }
    /// Not negative, and each of so many needs some byte of the rest.
    std::size_t checked(std::int64_t count) const
    {
        if (count < 0 || static_cast<std::size_t>(count) > m_text.left())
            m_text.failHere();
        return static_cast<std::size_t>(count);
    }

private:
    TextScanner& m_text;
    bool m_isBinary;
    bool m_isVersion4;
};

/// Values at nodes, to be read when they are chosen.
struct GmshView {
    std::string name;
    std::string time;
    std::int64_t step = 0;
    std::int64_t components = 0;
    std::size_t count = 0;
    std::size_t place = 0;
};

/// Gmsh's meshes of versions 2 and 4 with values at nodes.
class GmshReader {
public:
    GmshReader(std::string_view bytes, const FieldRequest& request, TaskControl& control)
        : m_request(request)
        , m_text(bytes, control)
    {
    }

    FieldContent run()
    {
        m_content.format = "Gmsh";
        while (!m_text.isAtEnd())
            readSection(trimmedText(m_text.line()));
        if (m_content.nodes.empty())
            throw Problem(Message("Field", "it has no nodes; write the results with the mesh."));
        if (m_request.isForMesh)
            connectCells(m_content);
        else
            readChosen();
        return std::move(m_content);
    }

private:
    void readSection(std::string_view head)
    {
        if (head == "$MeshFormat")
            readFormat();
        else if (head == "$Nodes")
            m_isVersion4 ? readNodeBlocks() : readNodeList();
        else if (head == "$Elements" && m_request.isForMesh)
            m_isVersion4 ? readElementBlocks() : readElementList();
        else if (head == "$NodeData")
            noteView();
        else if (head.starts_with('$') && !head.starts_with("$End"))
            skipSection(head.substr(1));
    }

    void skipSection(std::string_view name)
    {
        std::string end = "\n$End";
        end += name;
        m_text.skipBehind(end);
    }

    void readFormat()
    {
        const double version = m_text.number();
        m_isVersion4 = version >= 4;
        m_isBinary = m_text.wholeNumber() == 1;
        m_text.line();
        if (version != 4.1 && (version < 2 || version >= 3))
            throw Problem(
                Message("Field", "it is a Gmsh file of version %1, which is not read; save it in version 4.1 or 2.2.")
                    .with(shortNumber(version)));
        if (m_isBinary && numberAt<std::int32_t>(m_text.block(4), 0) != 1)
            throw Problem(
                Message("Field", "its bytes are in the order of another kind of computer; save it as text (ASCII)."));
    }

    GmshNumbers numbers() { return {m_text, m_isBinary, m_isVersion4}; }

    void addNode(std::int64_t label, const Vec3& node)
    {
        m_content.labels.push_back(label);
        m_content.nodes.push_back(node);
    }

    void readNodeList()
    {
        const std::size_t count = m_text.count();
        m_text.line();
        GmshNumbers from = numbers();
        for (std::size_t i = 0; i < count; ++i) {
            const std::int64_t label = from.whole();
            addNode(label, from.vector());
        }
    }

    /// Per entity its tags, then its nodes with as many parameters as it has dimensions where they are wanted.
    void readNodeBlocks()
    {
        GmshNumbers from = numbers();
        const std::size_t blocks = from.checked(from.tag());
        for (int i = 0; i < 3; ++i)
            from.tag(); // how many nodes, and the least and largest number
        for (std::size_t block = 0; block < blocks; ++block) {
            const std::int64_t dimension = from.whole();
            from.whole();
            const bool isParametric = from.whole() != 0;
            const std::size_t count = from.checked(from.tag());
            const std::size_t first = m_content.labels.size();
            for (std::size_t i = 0; i < count; ++i)
                addNode(from.tag(), noVector());
            for (std::size_t i = 0; i < count; ++i) {
                m_content.nodes[first + i] = from.vector();
                for (std::int64_t parameter = 0; isParametric && parameter < std::min<std::int64_t>(dimension, 3);
                     ++parameter)
                    from.real();
            }
        }
    }

    const GmshElement& element(std::int64_t type) const
    {
        const GmshElement* element = gmshElement(type);
        if (element == nullptr)
            throw Problem(
                Message("Field", "it has elements of Gmsh's type %1, which is not known; leave them out.").with(type));
        return *element;
    }

    void readElementList()
    {
        const std::size_t count = m_text.count();
        m_text.line();
        GmshNumbers from = numbers();
        for (std::size_t i = 0; i < count;) {
            const std::int64_t label = m_isBinary ? 0 : from.whole();
            const GmshElement& one = element(from.whole());
            const std::size_t together = m_isBinary ? from.checked(from.whole()) : 1;
            const std::size_t tags = from.checked(from.whole());
            if (together == 0 || label < 0)
                m_text.failHere();
            for (std::size_t j = 0; j < together; ++j) {
                for (std::size_t skipped = 0; skipped < tags + (m_isBinary ? 1 : 0); ++skipped)
                    from.whole();
                addElement(one, [&] { return from.whole(); });
            }
            i += together;
        }
    }

    void readElementBlocks()
    {
        GmshNumbers from = numbers();
        const std::size_t blocks = from.checked(from.tag());
        for (int i = 0; i < 3; ++i)
            from.tag();
        for (std::size_t block = 0; block < blocks; ++block) {
            from.whole();
            from.whole();
            const GmshElement& one = element(from.whole());
            const std::size_t count = from.checked(from.tag());
            for (std::size_t i = 0; i < count; ++i) {
                from.tag();
                addElement(one, [&] { return from.tag(); });
            }
        }
    }

    /// With labels in place of nodes for now.
    template <typename NextLabel>
    void addElement(const GmshElement& element, NextLabel&& nextLabel)
    {
        m_labelsOfOne.resize(element.nodes);
        std::ranges::generate(m_labelsOfOne, nextLabel);
        if (element.vtkType == 0)
            return;
        for (std::size_t i = 0; i < element.nodes; ++i)
            m_content.cells.connectivity.push_back(m_labelsOfOne[element.order.empty() ? i : element.order[i]]);
        m_content.cells.endCell(element.vtkType);
    }

    /// The lines before the values: texts, of which the first is the name; numbers, of which the first is the time; whole
    /// numbers: the step, how many components, how many nodes.
    void noteView()
    {
        GmshView view;
        const std::size_t texts = m_text.count();
        m_text.line();
        for (std::size_t i = 0; i < texts && !m_text.isAtEnd(); ++i)
            if (const std::string_view line = trimmedText(m_text.line()); i == 0)
                view.name =
                    readableName(line.size() > 1 && line.front() == '"' ? line.substr(1, line.size() - 2) : line);
        const std::size_t reals = m_text.count();
        for (std::size_t i = 0; i < reals; ++i)
            if (const double real = m_text.number(); i == 0)
                view.time = shortNumber(real);
        std::array<std::int64_t, 3> wholes{};
        const std::size_t all = m_text.count();
        for (std::size_t i = 0; i < all; ++i)
            if (const std::int64_t whole = m_text.wholeNumber(); i < wholes.size())
                wholes[i] = whole;
        m_text.line();
        view.step = wholes[0];
        view.components = wholes[1];
        view.count = numbers().checked(wholes[2]);
        view.place = m_text.place();
        if (view.components == 3)
            m_views.push_back(view);
        skipValues(view);
    }

    void skipValues(const GmshView& view)
    {
        if (m_isBinary) {
            for (std::size_t i = 0; i < view.count; ++i)
                m_text.block(4 + 8 * numbers().checked(view.components));
        } else if (!m_text.skipBehind("$EndNodeData")) {
            m_text.failHere();
        }
    }

    void readChosen()
    {
        for (const GmshView& view : m_views)
            if (std::ranges::find(m_content.names, view.name) == m_content.names.end())
                m_content.names.push_back(view.name);
        const std::string name = m_content.names[chosenName(m_request.choice, m_content.names)];
        std::vector<const GmshView*> ofName;
        for (const GmshView& view : m_views)
            if (view.name == name)
                ofName.push_back(&view);
        std::ranges::stable_sort(ofName, {}, &GmshView::step);
        for (const GmshView* view : ofName)
            m_content.steps.push_back(view->time.empty() ? std::to_string(view->step) : view->time);
        choose(m_request.choice, m_content);
        m_content.valueUnit = unitIn(name);
        readValues(*ofName[m_content.step]);
    }

    void readValues(const GmshView& view)
    {
        m_content.values.assign(m_content.nodes.size(), noVector());
        LabelMap places(m_content.labels);
        m_text.goTo(view.place);
        GmshNumbers from = numbers();
        for (std::size_t i = 0; i < view.count; ++i) {
            const std::size_t place = places.find(from.whole());
            const Vec3 value = from.vector();
            if (place != LabelMap::none)
                m_content.values[place] = value;
        }
    }

    const FieldRequest& m_request;
    TextScanner m_text;
    bool m_isBinary = false;
    bool m_isVersion4 = false;
    FieldContent m_content;
    std::vector<GmshView> m_views;
    std::vector<std::int64_t> m_labelsOfOne;
};

} // namespace

FieldContent readGmsh(std::string_view bytes, const FieldRequest& request, TaskControl& control)
{
    return GmshReader(bytes, request, control).run();
}

} // namespace knead
