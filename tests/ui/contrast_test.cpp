#include "support/contrast.h"
#include "ui/interaction/key_cards.h"
#include "ui/theme.h"
#include "ui/viewport/view_name.h"

#include <QApplication>
#include <QPainter>
#include <QPalette>
#include <QRegularExpression>
#include <QtTest>

#include <map>

using namespace knead;

namespace {

constexpr double readable = 4.5;    // WCAG 2.1, level AA
constexpr double disabledLeast = 3; // of what cannot be used now

/// One rule of a style sheet: where it holds and what it says.
struct Rule {
    QString selector;
    QMap<QString, QString> says;

    bool isDisabled() const { return selector.contains(":disabled"); }
    /// A line, a groove or the like, on which nothing is written.
    bool isBare() const
    {
        return selector.contains("separator") || selector.contains("::chunk") || says.value("width") == "1px";
    }
    QColor color(const QString& what) const
    {
        const QColor found(says.value(what));
        return says.contains(what) && found.isValid() && found.alpha() == 255 ? found : QColor();
    }
};

std::vector<Rule> rulesOf(const QString& sheet)
{
    std::vector<Rule> rules;
    static const QRegularExpression block("([^{}]+)\\{([^{}]*)\\}");
    for (auto found = block.globalMatch(sheet); found.hasNext();) {
        const auto match = found.next();
        Rule rule{match.captured(1).simplified(), {}};
        for (const QString& line : match.captured(2).split(';', Qt::SkipEmptyParts))
            rule.says[line.section(':', 0, 0).simplified()] = line.section(':', 1).simplified();
        rules.push_back(rule);
    }
    return rules;
}

/// The color that most of a picture has, and the one in it that is furthest from that: ground and text.
double contrastIn(const QImage& image)
{
    std::map<QRgb, int> counts;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            ++counts[image.pixel(x, y)];
    QRgb ground = 0;
    for (const auto& [color, count] : counts)
        if (ground == 0 || count > counts[ground])
            ground = color;
    double most = 1;
    for (const auto& [color, count] : counts)
        most = std::max(most, contrastOf(color, ground));
    return most;
}

} // namespace

/// Whether texts stand out from what they are written on, in both themes, as WCAG 2.1 asks at level AA.
class ContrastTest : public QObject {
    Q_OBJECT

private slots:
    void themes_data()
    {
        QTest::addColumn<int>("theme");
        QTest::newRow("light") << int(Theme::Light);
        QTest::newRow("dark") << int(Theme::Dark);
    }

    void thePaletteIsReadable_data() { themes_data(); }

    void thePaletteIsReadable()
    {
        begin();
        using P = QPalette;
        const std::pair<P::ColorRole, std::vector<P::ColorRole>> texts[] = {
            {P::WindowText, {P::Window, P::Base, P::AlternateBase, P::Button, P::ToolTipBase}},
            {P::Text, {P::Window, P::Base, P::AlternateBase, P::Button, P::ToolTipBase}},
            {P::ButtonText, {P::Window, P::Base, P::Button, P::ToolTipBase}},
            {P::ToolTipText, {P::ToolTipBase}},
            {P::PlaceholderText, {P::Window, P::Base, P::AlternateBase, P::Button, P::ToolTipBase}},
            {P::Link, {P::Window, P::Base, P::AlternateBase, P::ToolTipBase}},
            {P::BrightText, {P::Window, P::Base, P::AlternateBase, P::ToolTipBase}},
            {P::HighlightedText, {P::Highlight}},
        };
        for (const auto& [text, grounds] : texts)
            for (const P::ColorRole ground : grounds) {
                compare(m_palette.color(text), m_palette.color(ground), readable,
                        QStringLiteral("%1 on %2").arg(roleName(text), roleName(ground)));
                if (text == P::WindowText || text == P::Text || text == P::ButtonText)
                    compare(m_palette.color(P::Disabled, text), m_palette.color(ground), disabledLeast,
                            QStringLiteral("disabled %1 on %2").arg(roleName(text), roleName(ground)));
            }
        finish();
    }

    void theStyleSheetIsReadable_data() { themes_data(); }

    /// A rule without a text has that of the palette; one without a ground may lie on a window, a list or a card.
    void theStyleSheetIsReadable()
    {
        begin();
        int pairs = 0;
        for (const Rule& rule : rulesOf(qApp->styleSheet())) {
            const QColor own = rule.color("color");
            const QColor ground = rule.color("background");
            if (rule.isBare() || (!own.isValid() && !ground.isValid()))
                continue;
            const QColor text = own.isValid() ? own : m_palette.color(QPalette::Text);
            const std::vector<QColor> grounds =
                ground.isValid() ? std::vector{ground}
                                 : std::vector{m_palette.color(QPalette::Window), m_palette.color(QPalette::Base),
                                               m_palette.color(QPalette::ToolTipBase)};
            for (const QColor& one : grounds) {
                compare(text, one, rule.isDisabled() ? disabledLeast : readable, rule.selector + " on " + one.name());
                if (rule.selector.startsWith("QFrame#") || rule.selector.startsWith("QWidget#")) // labels lie on it
                    compare(m_palette.color(QPalette::PlaceholderText), one, readable, "dimmed on " + rule.selector);
                ++pairs;
            }
        }
        QVERIFY(pairs > 25);
        finish();
    }

    void whatLiesOnTheViewIsReadable_data() { themes_data(); }

    /// Names of views, legend and keys let the scene shine through: it may be white or black there.
    void whatLiesOnTheViewIsReadable()
    {
        begin();
        for (const QColor scene : {QColor(Qt::white), QColor(Qt::black)}) {
            ViewName name(nullptr);
            name.show("Front (XZ)", false);
            name.resize(name.sizeHint());
            asSeen(name, scene, "name of a view");
            QImage keys(keyCardsSize(), QImage::Format_RGB32);
            keys.fill(scene);
            QPainter painter(&keys);
            drawKeyCards(painter, keys.rect(), std::array<QString, drivenTools>{"Block"}, {}, "20 mm/s", m_palette);
            painter.end();
            const double contrast = contrastIn(keys);
            if (contrast < readable)
                m_failures << QStringLiteral("keys on %1: %2").arg(scene.name()).arg(contrast);
        }
        finish();
    }

private:
    void begin()
    {
        QFETCH(int, theme);
        applyTheme(*qApp, static_cast<Theme>(theme));
        m_palette = QApplication::palette();
        m_failures.clear();
    }

    void finish() { QVERIFY2(m_failures.isEmpty(), qPrintable(m_failures.join("\n"))); }

    void compare(const QColor& text, const QColor& ground, double least, const QString& what)
    {
        if (const double contrast = contrastOf(text, ground); contrast < least)
            m_failures << QStringLiteral("%1: %2, not %3").arg(what).arg(contrast, 0, 'f', 2).arg(least);
    }

    void asSeen(QWidget& widget, const QColor& scene, const QString& what)
    {
        QImage image(widget.size(), QImage::Format_RGB32);
        image.fill(scene);
        widget.render(&image, {}, {}, QWidget::DrawChildren);
        if (const double contrast = contrastIn(image); contrast < readable)
            m_failures << QStringLiteral("%1 on %2: %3").arg(what, scene.name()).arg(contrast, 0, 'f', 2);
    }

    static QString roleName(QPalette::ColorRole role)
    {
        return QMetaEnum::fromType<QPalette::ColorRole>().valueToKey(role);
    }

    QPalette m_palette;
    QStringList m_failures;
};

QTEST_MAIN(ContrastTest)
#include "contrast_test.moc"
