#include "ui/viewport/force_labels.h"

#include "ui/units.h"

#include <QLabel>

#include <algorithm>
#include <utility>

namespace knead {

namespace {

constexpr double labelledForce = 1e-6; // [N]
constexpr int labelDistance = 10;      // beside the place [pixels]

} // namespace

QLabel* ForceLabels::newLabel(ToolId tool) const
{
    auto* label = new QLabel(m_view);
    label->setObjectName(QStringLiteral("forceLabel%1").arg(tool));
    label->setProperty("role", "force");
    label->setAttribute(Qt::WA_TransparentForMouseEvents);
    label->show();
    return label;
}

void ForceLabels::place(const std::vector<SceneLabel>& labels,
                        const std::function<std::optional<QPointF>(const Vec3& place)>& seenAt)
{
    std::map<ToolId, QLabel*> shown;
    for (const SceneLabel& wanted : labels) {
        const std::optional<QPointF> position = seenAt(wanted.place);
        if (!position || wanted.force < labelledForce)
            continue;
        QLabel*& label = m_labels[wanted.tool];
        if (label == nullptr)
            label = newLabel(wanted.tool);
        label->setText(formatReading(wanted.force, Quantity::Force));
        label->adjustSize();
        const std::optional<QPointF> middle = seenAt(wanted.middle);
        const bool isLeft = middle && position->x() < middle->x() - labelDistance; // away from the handles of the tool
        const int x = static_cast<int>(position->x()) + (isLeft ? -labelDistance - label->width() : labelDistance);
        const int y = static_cast<int>(position->y()) - label->height() / 2;
        label->move(std::clamp(x, 0, std::max(0, m_view->width() - label->width())),
                    std::clamp(y, 0, std::max(0, m_view->height() - label->height())));
        shown[wanted.tool] = label;
        m_labels.erase(wanted.tool);
    }
    for (const auto& [tool, label] : m_labels)
        delete label;
    m_labels = std::move(shown);
}

} // namespace knead
