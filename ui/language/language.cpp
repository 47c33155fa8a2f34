#include "ui/language/language.h"

#include "ui/language/retranslation.h"
#include "ui/units.h"

#include <QCoreApplication>
#include <QHash>
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

/// A text of the source code, as tr() asks for it.
struct Phrase {
    QByteArray context; ///< mostly the class that says it
    QByteArray source;
    QByteArray comment;
    int count; ///< that decides between singular and plural; -1: none
    friend bool operator==(const Phrase&, const Phrase&) = default;
};

std::size_t qHash(const Phrase& phrase, std::size_t seed = 0)
{
    return qHashMulti(seed, phrase.context, phrase.source, phrase.comment, phrase.count);
}

/// Asks our translations, then those of Qt, and notes what it says. Tasks say things too, on their threads.
class Interpreter final : public QTranslator {
public:
    using QTranslator::QTranslator;

    bool isEmpty() const override { return false; }

    QString translate(const char* context, const char* source, const char* comment, int count) const override
    {
        const Phrase phrase{context, source, comment, count};
        const std::lock_guard lock(m_mutex);
        QString& said = m_said[phrase];
        if (said.isNull())
            said = noted(inWords(context, source, comment, count), [phrase] {
                return QCoreApplication::translate(phrase.context, phrase.source,
                                                   phrase.comment.isNull() ? nullptr : phrase.comment.data(),
                                                   phrase.count);
            });
        return said;
    }

    void change(const QString& code)
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
        m_said.clear();
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
    mutable QHash<Phrase, QString> m_said; ///< one string for each, however often it is asked for
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
    setNumberLanguage(code);
    now.change(code);
    QEvent change(QEvent::LanguageChange); // Qt's own texts, and who wants to know
    QCoreApplication::sendEvent(QCoreApplication::instance(), &change);
    retranslate();
}

QString spokenLanguage()
{
    return interpreter().code();
}

} // namespace knead
