#include "ui/selection/selection_model.h"

#include "ui/document/document.h"

#include <QScopedValueRollback>

#include <utility>

namespace knead {

namespace {

Region combined(const Region& before, const Region& region, SelectionModel::How how)
{
    using How = SelectionModel::How;
    if (how == How::Replace || (before.level != region.level && how != How::Remove))
        return region;
    if (before.level != region.level)
        return before;
    return how == How::Add      ? united(before, region)
           : how == How::Remove ? without(before, region)
                                : toggled(before, region);
}

bool isOfObjects(Level level)
{
    return level == Level::Object || level == Level::Connection;
}

} // namespace

bool isOnePart(const Region& region)
{
    return region.level == Level::Part && region.items.size() == 1;
}

SelectionModel::SelectionModel(Document& document)
    : QObject(&document)
    , m_document(document)
{
    connect(&document, &Document::changed, this, [this](Document::Change what) {
        if (what == Document::Change::Model) {
            m_region = {};
            follow();
            emit changed();
        } else if (what == Document::Change::Filling && isOfObjects(m_region.level) && m_fillings != fillings()) {
            clear(); // there are others now
        } else if (what == Document::Change::Selection && !m_isTelling) {
            follow();
        }
    });
}

void SelectionModel::setLevel(Level level)
{
    if (std::exchange(m_level, level) != level)
        emit levelChanged();
}

void SelectionModel::setThrough(bool on)
{
    m_isThrough[static_cast<std::size_t>(m_level)] = on;
    emit levelChanged();
}

void SelectionModel::select(const Region& region, How how)
{
    Region wanted = combined(m_region, region, how);
    if (wanted.isEmpty())
        wanted = {};
    const bool isSame = wanted == m_region;
    m_region = std::move(wanted);
    m_fillings = fillings();
    tellDocument(); // also a tool may be selected
    if (!isSame)
        emit changed();
}

void SelectionModel::clear()
{
    select({});
}

/// Somebody selected a body, a tool or a fixture.
void SelectionModel::follow()
{
    const Selection& selection = m_document.selection();
    if (selection.kind == Selection::Kind::Region)
        return;
    Region region;
    if (selection.kind == Selection::Kind::Body)
        region.add(selection.id, 0);
    if (std::exchange(m_region, region) != region)
        emit changed();
}

std::vector<std::shared_ptr<const Aggregate>> SelectionModel::fillings() const
{
    std::vector<std::shared_ptr<const Aggregate>> all;
    for (const auto& body : m_document.content().bodies)
        all.push_back(body->aggregate);
    return all;
}

void SelectionModel::tellDocument()
{
    const QScopedValueRollback telling(m_isTelling, true);
    if (m_region.isEmpty())
        m_document.select({});
    else if (isOnePart(m_region))
        m_document.select({Selection::Kind::Body, m_region.items.begin()->first});
    else
        m_document.select({Selection::Kind::Region, 0});
}

} // namespace knead
