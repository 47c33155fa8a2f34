#pragma once

#include "core/session/region.h"

#include <QObject>

#include <memory>
#include <vector>

namespace knead {

struct Aggregate;
class Document;

/// What is selected, down to faces, edges, objects and connections, and what a click would select. View, tree and panels show this
/// together; it is no part of the document. Window thread.
///
/// Selection, which names one body, tool or fixture for the properties, follows: one part is Kind::Body, more than that or less is
/// Kind::Region.
class SelectionModel final : public QObject {
    Q_OBJECT
public:
    enum class How { Replace, Add, Remove, Toggle };

    explicit SelectionModel(Document& document);

    Level level() const { return m_level; }
    void setLevel(Level level);

    const Region& region() const { return m_region; }
    /// Selects. What is of another level than the region takes its place.
    void select(const Region& region, How how = How::Replace);
    void clear();
    /// The content is about to be another one: what was selected is not there any more.
    void forget() { m_region = {}; }

    /// Whether regions of the screen take what is hidden behind the skin too: at first so for objects and connections.
    bool isThrough() const { return m_isThrough[static_cast<std::size_t>(m_level)]; }
    void setThrough(bool on);

signals:
    void changed();
    void levelChanged(); ///< or isThrough()

private:
    void follow();
    void tellDocument();
    std::vector<std::shared_ptr<const Aggregate>> fillings() const;

    Document& m_document;
    Level m_level = Level::Part;
    bool m_isThrough[levelCount] = {true, false, false, true, true};
    Region m_region;
    std::vector<std::shared_ptr<const Aggregate>> m_fillings; ///< that its objects are of
    bool m_isTelling = false;
};

/// What has to be selected for a region to be this one, in the properties.
bool isOnePart(const Region& region);

} // namespace knead
