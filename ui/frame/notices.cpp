#include "ui/frame/notices.h"

#include "ui/language/retranslation.h"
#include "ui/panels/banner.h"
#include "ui/panels/log_panel.h"

#include <utility>

namespace knead {

Notices::Notices(Banner& banner, LogPanel& log, QObject* parent)
    : QObject(parent)
    , m_banner(banner)
    , m_log(log)
{
    connect(&m_banner, &Banner::remedyClicked, this, [this] {
        if (m_remedy)
            m_remedy();
    });
    connect(&m_banner, &Banner::otherClicked, this, &Notices::otherClicked);
}

void Notices::problem(const QString& sentence, const QString& remedyText, Remedy remedy)
{
    advise(sentence, remedyText, std::move(remedy));
    m_log.add(sentence, LogPanel::Kind::Error);
}

void Notices::trouble(const QString& sentence, const QString& remedyText, Remedy remedy, const QString& other)
{
    problem(sentence, remedyText, std::move(remedy));
    m_banner.show(sentence, remedyText, other);
}

void Notices::advise(const QString& sentence, const QString& remedyText, Remedy remedy)
{
    m_remedy = std::move(remedy);
    m_banner.show(sentence, remedyText);
}

void Notices::remark(const QString& sentence)
{
    m_log.add(sentence, LogPanel::Kind::Warning);
    const bool hasRemedy = !m_banner.isHidden() && m_remedy != nullptr;
    if (!m_isGrave && !hasRemedy)
        advise(sentence, {}, nullptr);
}

void Notices::note(const QString& sentence)
{
    m_log.add(sentence);
}

void Notices::warn(const QString& sentence)
{
    m_log.add(sentence, LogPanel::Kind::Warning);
}

QString Notices::shown() const
{
    return m_banner.sentence();
}

void Notices::hide()
{
    m_banner.hide();
}

void Notices::withdraw(const QString& sentence)
{
    if (!sentence.isEmpty() && shown() == saidAnew(sentence))
        hide();
}

} // namespace knead
