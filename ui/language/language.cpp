#include "ui/language/language.h"

#include "ui/language/retranslation.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QPointer>
#include <QTranslator>

#include <algorithm>
#include <mutex>
#include <string_view>
#include <utility>

// The resources of a static library are not found by themselves; the macro must stand outside of namespaces.
static void initializeTranslations()
{
    Q_INIT_RESOURCE(translations);
}

namespace knead {

namespace {

constexpr Language ours[] = {{"en", "English"}, {"de", "Deutsch"}, {"fr", "Français"}, {"nl", "Nederlands"}};

bool isOurs(const QString& code)
{
    return std::ranges::any_of(ours, [&](const Language& language) { return code == QLatin1String(language.code); });
}

const char* withoutNamespace(const char* context)
{
    constexpr std::string_view name = "knead::";
    return std::string_view(context).starts_with(name) ? context + name.size() : context;
}

/// Asks our translations, then those of Qt, and keeps what it says. Tasks say things too, on their threads.
class Interpreter final : public QTranslator {
public:
    using QTranslator::QTranslator;

    bool isEmpty() const override { return false; }

    QString translate(const char* context, const char* source, const char* comment, int count) const override
    {
        const Phrase phrase{context, source, comment, count};
        const std::lock_guard lock(m_mutex);
        QString& said = m_said[phrase];
        if (said.isNull()) {
            said = inWords(context, source, comment, count);
            if (const auto before = m_before.constFind(phrase); before != m_before.constEnd() && *before == said)
                said = *before; // who shows it keeps it when given its like
        }
        return said;
    }

    /// @return what was said in the language before, until the next change
    const SaidPhrases& change(const QString& code)
    {
        auto own = std::make_unique<QTranslator>();
        auto qt = std::make_unique<QTranslator>();
        if (!own->load(QStringLiteral(":/translations/knead_%1.qm").arg(code)))
            qFatal("the translation %s is missing", qPrintable(code));
        // English needs none; without Qt's package its few texts stay English.
        const bool isKnown = qt->load("qtbase_" + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
        Q_UNUSED(isKnown);
        const std::lock_guard lock(m_mutex);
        m_code = code;
        m_own = std::move(own);
        m_qt = std::move(qt);
        m_before = std::exchange(m_said, {});
        return m_before;
    }

    const QString& code() const { return m_code; }

private:
    QString inWords(const char* context, const char* source, const char* comment, int count) const
    {
        // lupdate writes contexts without the namespace.
        if (QString said = m_own->translate(withoutNamespace(context), source, comment, count); !said.isNull())
            return said;
        const QString said = m_qt->translate(context, source, comment, count);
        return said.isNull() ? QString::fromUtf8(source) : said;
    }

    mutable std::mutex m_mutex;
    QString m_code;
    std::unique_ptr<QTranslator> m_own = std::make_unique<QTranslator>();
    std::unique_ptr<QTranslator> m_qt = std::make_unique<QTranslator>();
    mutable SaidPhrases m_said; ///< in the language of now
    SaidPhrases m_before;       ///< in the one before
};

/// It goes with the application.
Interpreter& interpreter()
{
    static QPointer<Interpreter> one;
    if (one == nullptr) {
        initializeTranslations();
        one = new Interpreter(QCoreApplication::instance());
        one->change("en");
        QCoreApplication::installTranslator(one);
    }
    return *one;
}

} // namespace

std::span<const Language> languages()
{
    return ours;
}

QString languageFor(const QString& wanted)
{
    if (isOurs(wanted))
        return wanted;
    for (const QString& name : QLocale::system().uiLanguages()) {
        const QString code = name.section('-', 0, 0);
        if (isOurs(code))
            return code;
    }
    return "en";
}

void speak(const QString& code)
{
    Interpreter& now = interpreter();
    if (now.code() == code || !isOurs(code))
        return;
    const SaidPhrases& before = now.change(code);
    QEvent change(QEvent::LanguageChange); // Qt's own texts, and who wants to know
    QCoreApplication::sendEvent(QCoreApplication::instance(), &change);
    retranslate(before);
}

QString spokenLanguage()
{
    return interpreter().code();
}

} // namespace knead
