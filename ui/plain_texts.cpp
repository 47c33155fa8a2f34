#include "ui/plain_texts.h"

#include <QApplication>
#include <QEvent>
#include <QLabel>

namespace knead {

namespace {

constexpr const char* plainTextsName = "plainTexts";

/// Tool tips are labels, too.
class PlainTexts final : public QObject {
public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override
    {
        if (event->type() != QEvent::Polish)
            return false;
        if (auto* label = qobject_cast<QLabel*>(watched); label != nullptr && label->textFormat() == Qt::AutoText)
            label->setTextFormat(Qt::PlainText);
        return false;
    }
};

} // namespace

void showTextsAsTheyStand()
{
    if (qApp->findChild<QObject*>(plainTextsName, Qt::FindDirectChildrenOnly) != nullptr)
        return;
    auto* texts = new PlainTexts(qApp);
    texts->setObjectName(plainTextsName);
    qApp->installEventFilter(texts);
}

} // namespace knead
