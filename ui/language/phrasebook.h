#pragma once

#include <QByteArray>
#include <QByteArrayList>
#include <QHash>
#include <QRegularExpression>
#include <QString>

#include <functional>
#include <optional>
#include <vector>

namespace knead {

/// A text of the source code, as a translator is asked for it.
struct Phrase {
    QByteArray context; ///< mostly the class that says it
    QByteArray source;
    QByteArray comment;
    friend bool operator==(const Phrase&, const Phrase&) = default;
};

/// What was said in a language so far, the other way around: finds the phrases that a shown text was made of, so that it can
/// be said in another language. One thread at a time.
class Phrasebook {
public:
    /// Says a phrase in another language. @param count that is in it; -1: none
    using Speaker = std::function<QString(const Phrase&, int count)>;

    void add(const QString& said, const Phrase& phrase);

    /// A shown text as `speaker` says it: also one into which numbers, names or other phrases were put. A text that was never
    /// said here stays as it is.
    /// @param contexts of who shows it: of phrases that read alike, theirs is taken
    QString translated(const QString& shown, const QByteArrayList& contexts, const Speaker& speaker) const;

    /// The same for a phrase that one of `contexts` said whole, and nobody else; none: it was not.
    std::optional<QString> ownPhrase(const QString& shown, const QByteArrayList& contexts,
                                     const Speaker& speaker) const;

private:
    struct Template {
        QRegularExpression shape;
        std::vector<int> places; ///< of the captures: 1 for %1; 0 for %n
        Phrase phrase;
        qsizetype letters = 0; ///< of its own
    };

    std::optional<QString> whole(const QString& shown, const QByteArrayList& contexts, const Speaker& speaker) const;
    std::optional<QString> filled(const QString& shown, const QByteArrayList& contexts, const Speaker& speaker) const;
    void prepareTemplates() const;

    QHash<QString, std::vector<Phrase>> m_phrases; ///< by what was said
    mutable std::vector<Template> m_templates;     ///< of those with places in them; made when first needed
    mutable bool m_isPrepared = false;
};

} // namespace knead
