#include "ui/language/phrasebook.h"

#include <algorithm>

namespace knead {

namespace {

constexpr qsizetype leastLetters = 3; // a shape with fewer of its own would fit anything

const QRegularExpression& placePattern()
{
    static const QRegularExpression pattern(QStringLiteral("%(?:L?(\\d{1,2})|n)"));
    return pattern;
}

qsizetype lettersIn(const QString& text)
{
    return std::ranges::count_if(text, [](QChar c) { return c.isLetter(); });
}

/// `said` with its places filled anew.
QString fill(const QString& said, const QHash<int, QString>& values)
{
    QString result;
    qsizetype end = 0;
    for (auto places = placePattern().globalMatch(said); places.hasNext();) {
        const QRegularExpressionMatch place = places.next();
        result += said.mid(end, place.capturedStart() - end);
        result += values.value(place.captured(1).toInt(), place.captured());
        end = place.capturedEnd();
    }
    return result + said.mid(end);
}

} // namespace

void Phrasebook::add(const QString& said, const Phrase& phrase)
{
    std::vector<Phrase>& phrases = m_phrases[said];
    if (std::ranges::find(phrases, phrase) != phrases.end())
        return;
    phrases.push_back(phrase);
    m_isPrepared = false;
}

QString Phrasebook::translated(const QString& shown, const QByteArrayList& contexts, const Speaker& speaker) const
{
    if (lettersIn(shown) == 0)
        return shown;
    if (const std::optional<QString> same = whole(shown, contexts, speaker))
        return *same;
    return filled(shown, contexts, speaker).value_or(shown);
}

std::optional<QString> Phrasebook::ownPhrase(const QString& shown, const QByteArrayList& contexts,
                                             const Speaker& speaker) const
{
    const auto found = m_phrases.constFind(shown);
    if (found == m_phrases.constEnd())
        return std::nullopt;
    for (const QByteArray& context : contexts) // the nearest first
        for (const Phrase& phrase : *found)
            if (phrase.context == context)
                return speaker(phrase, -1);
    return std::nullopt;
}

std::optional<QString> Phrasebook::whole(const QString& shown, const QByteArrayList& contexts,
                                         const Speaker& speaker) const
{
    if (const std::optional<QString> own = ownPhrase(shown, contexts, speaker))
        return own;
    const auto found = m_phrases.constFind(shown);
    if (found == m_phrases.constEnd())
        return std::nullopt;
    return speaker(found->front(), -1);
}

/// The shape with the most letters of its own that fits. What was put into it may be phrases in turn.
std::optional<QString> Phrasebook::filled(const QString& shown, const QByteArrayList& contexts,
                                          const Speaker& speaker) const
{
    prepareTemplates();
    for (const Template& one : m_templates) {
        const QRegularExpressionMatch match = one.shape.match(shown);
        if (!match.hasMatch())
            continue;
        QHash<int, QString> values;
        int count = -1;
        for (std::size_t i = 0; i < one.places.size(); ++i) {
            const QString value = match.captured(static_cast<int>(i) + 1);
            if (one.places[i] == 0)
                count = value.toInt();
            values[one.places[i]] = translated(value, contexts, speaker);
        }
        return fill(speaker(one.phrase, count), values);
    }
    return std::nullopt;
}

void Phrasebook::prepareTemplates() const
{
    if (std::exchange(m_isPrepared, true))
        return;
    m_templates.clear();
    for (auto said = m_phrases.constBegin(); said != m_phrases.constEnd(); ++said) {
        Template one;
        QString shape;
        qsizetype end = 0;
        for (auto places = placePattern().globalMatch(said.key()); places.hasNext();) {
            const QRegularExpressionMatch place = places.next();
            const QString piece = said.key().mid(end, place.capturedStart() - end);
            one.letters += lettersIn(piece);
            shape += QRegularExpression::escape(piece) + "(.+?)";
            one.places.push_back(place.captured(1).toInt());
            end = place.capturedEnd();
        }
        const QString rest = said.key().mid(end);
        one.letters += lettersIn(rest);
        if (one.places.empty() || one.letters < leastLetters)
            continue;
        one.shape.setPattern(QRegularExpression::anchoredPattern(shape + QRegularExpression::escape(rest)));
        one.shape.setPatternOptions(QRegularExpression::DotMatchesEverythingOption);
        one.phrase = said->front();
        m_templates.push_back(std::move(one));
    }
    std::ranges::sort(m_templates, std::ranges::greater(), &Template::letters);
}

} // namespace knead
