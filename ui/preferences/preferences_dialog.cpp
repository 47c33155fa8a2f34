#include "ui/preferences/preferences_dialog.h"

#include "ui/commands/shortcuts.h"
#include "ui/commands/shortcuts_page.h"
#include "ui/language/language.h"
#include "ui/language/said.h"
#include "ui/panels/form.h"
#include "ui/theme.h"
#include "ui/viewport/navigation.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QLabel>
#include <QListWidget>
#include <QMainWindow>
#include <QPushButton>
#include <QSpinBox>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <cmath>

namespace knead {

namespace {

constexpr int indexMargin = 24; // beside its words [pixels]

} // namespace

PreferencesDialog::PreferencesDialog(const Preferences& now, Shortcuts& shortcuts, QMainWindow& window)
    : QDialog(&window)
    , m_now(now)
    , m_shortcuts(shortcuts)
    , m_index(new QListWidget(this))
    , m_pages(new QStackedWidget(this))
{
    setObjectName("preferencesDialog");
    setWindowTitle(tr("Preferences"));
    m_index->setObjectName("preferencesIndex");
    m_index->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_pages->setObjectName("preferencesPages");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 12);
    column->setSpacing(12);
    auto* row = new QHBoxLayout;
    row->setSpacing(18);
    row->addWidget(m_index);
    row->addWidget(m_pages, 1);
    column->addLayout(row, 1);
    addGeneralPage();
    addMemoryPage();
    addFilesPage();
    addViewPage();
    m_index->addItem(tr("Keys"));
    m_pages->addWidget(new ShortcutsPage(window, shortcuts));
    addButtons(column);
    connect(m_index, &QListWidget::currentRowChanged, m_pages, &QStackedWidget::setCurrentIndex);
    m_index->setCurrentRow(0);
    setPreferences(now);
    m_index->setFixedWidth(m_index->sizeHintForColumn(0) + indexMargin);
    resize(withText(760), withText(520));
}

void PreferencesDialog::show(Page page)
{
    m_index->setCurrentRow(static_cast<int>(page));
    QDialog::show();
    raise();
    activateWindow();
}

void PreferencesDialog::setPreferences(const Preferences& now)
{
    m_now = now;
    m_isFilling = true;
    for (const Filling& fill : m_fillings)
        fill(now);
    m_isFilling = false;
}

QFormLayout* PreferencesDialog::addPage(const QString& title)
{
    auto* page = new QWidget(m_pages);
    QFormLayout* form = makeForm(page);
    form->setContentsMargins(0, 0, 0, 0);
    form->setVerticalSpacing(10);
    form->setFieldGrowthPolicy(QFormLayout::FieldsStayAtSizeHint);
    m_pages->addWidget(page);
    m_index->addItem(title);
    return form;
}

void PreferencesDialog::addGeneralPage()
{
    QFormLayout* form = addPage(tr("General"));
    addChoice(
        form, tr("Theme"), "preferenceTheme",
        {{tr("Light"), static_cast<int>(Preferences::Look::Light)},
         {tr("Dark"), static_cast<int>(Preferences::Look::Dark)},
         {tr("As the system"), static_cast<int>(Preferences::Look::System)}},
        [](const Preferences& p) { return QVariant(static_cast<int>(p.look)); },
        [](Preferences& p, const QVariant& value) { p.look = static_cast<Preferences::Look>(value.toInt()); });
    addChoice(
        form, tr("Text size"), "preferenceText", {{tr("100 %"), 100}, {tr("125 %"), 125}, {tr("150 %"), 150}},
        [](const Preferences& p) { return QVariant(p.textPercent); },
        [](Preferences& p, const QVariant& value) { p.textPercent = value.toInt(); });
    std::vector<Choice> spoken{{tr("As the system"), QString()}};
    for (const Language& language : languages())
        spoken.push_back({QString::fromUtf8(language.name), QString(language.code)});
    addChoice(
        form, tr("Language"), "preferenceLanguage", spoken, [](const Preferences& p) { return QVariant(p.language); },
        [](Preferences& p, const QVariant& value) { p.language = value.toString(); });
    addNote(form, tr("Names that you gave, and what the command line says, stay as they are."));
    addChoice(
        form, tr("Lengths in"), "preferenceUnit",
        {{tr("Millimetres (mm)"), "mm"},
         {tr("Centimetres (cm)"), "cm"},
         {tr("Metres (m)"), "m"},
         {tr("Inches (in)"), "in"}},
        [](const Preferences& p) { return QVariant(p.lengthUnit); },
        [](Preferences& p, const QVariant& value) { p.lengthUnit = value.toString(); });
    addNote(
        form,
        tr("Speeds and volumes follow. Every field takes numbers in any unit, such as 12.5 mm, 12,5 mm or 0.5 in."));
}

void PreferencesDialog::addMemoryPage()
{
    constexpr int most = 1 << 16;
    QFormLayout* form = addPage(tr("Memory and safety"));
    addNumber(form, tr("For undo"), "preferenceHistory", tr(" MB"), 16, most, &Preferences::historyMegabytes);
    addNote(form, tr("The oldest moments are dropped, and found again by repeating what was done."));
    addNumber(form, tr("For looking back"), "preferenceFilm", tr(" MB"), 16, most, &Preferences::filmMegabytes);
    addNote(form, tr("When it is full, every second picture of the older half goes."));
    auto* seconds = makeField(Quantity::Time, "preferenceKeeping", form->parentWidget());
    seconds->setRange(1, 60);
    form->addRow(tr("Keep unsaved work every"), seconds);
    m_fillings.push_back(
        [seconds](const Preferences& p) { seconds->setValue(static_cast<double>(p.keepingInterval.count())); });
    connect(seconds, &QuantityField::committed, this, [this](double value) {
        change([value](Preferences& p) { p.keepingInterval = std::chrono::seconds(std::lround(value)); });
        setPreferences(m_now); // whole seconds
    });
    addNote(form, tr("After a crash, no more than this and two seconds are lost."));
    QSpinBox* threads =
        addNumber(form, tr("Threads"), "preferenceThreads", {}, 0, mostThreads(), &Preferences::threads);
    threads->setSpecialValueText(said(Message("PreferencesDialog", "All (%1)").with(mostThreads())));
    addNote(form, tr("That compute. The results are the same for any number."));
}

void PreferencesDialog::addFilesPage()
{
    QFormLayout* form = addPage(tr("Files"));
    addChoice(
        form, tr("Triangles"), "preferenceDetail",
        {{tr("Coarse (0.2 % of the size)"), 2e-3},
         {tr("Normal (0.05 % of the size)"), 5e-4},
         {tr("Fine (0.0125 % of the size)"), 1.25e-4}},
        [](const Preferences& p) { return QVariant(p.detail); },
        [](Preferences& p, const QVariant& value) { p.detail = value.toDouble(); });
    addNote(
        form,
        tr("How far the triangles that are drawn and filled may lie beside the surfaces of a file. Open with choices "
           "asks for each file."));
    addNumber(form, tr("Give up reading after"), "preferenceMinutes", tr(" min"), 0, 10'000,
              &Preferences::importMinutes)
        ->setSpecialValueText(tr("Automatic"));
    addNumber(form, tr("or with more memory than"), "preferenceGibibytes", tr(" GiB"), 0, 1'000,
              &Preferences::importGibibytes)
        ->setSpecialValueText(tr("Automatic"));
    addNote(form, tr("Automatic: by the size of the file."));
}

void PreferencesDialog::addViewPage()
{
    QFormLayout* form = addPage(tr("3D view"));
    std::vector<Choice> presets;
    for (const NavigationPreset& preset : navigationPresets())
        presets.push_back({said(Message("Navigation", preset.title)), QString(preset.name)});
    addChoice(
        form, tr("Mouse as in"), "preferenceNavigation", presets,
        [](const Preferences& p) { return QVariant(p.navigation); },
        [](Preferences& p, const QVariant& value) { p.navigation = value.toString(); });
    addNote(form, tr("Which buttons orbit, pan and zoom; the status bar tells. The wheel zooms to the cursor."));
    addChoice(
        form, tr("Smooth edges"), "preferenceSmoothing",
        {{tr("Off"), 1}, {tr("2 samples"), 2}, {tr("4 samples"), 4}, {tr("8 samples"), 8}},
        [](const Preferences& p) { return QVariant(p.smoothing); },
        [](Preferences& p, const QVariant& value) { p.smoothing = value.toInt(); });
    addNote(form, tr("More is slower without a graphics card."));
    addSwitch(form, tr("Turn smoothly from one view to another"), "preferenceTurning", &Preferences::turnsSmoothly);
}

void PreferencesDialog::addButtons(QVBoxLayout* column)
{
    auto* row = new QHBoxLayout;
    auto* defaults = new QPushButton(tr("Restore defaults"), this);
    defaults->setObjectName("preferencesDefaults");
    defaults->setAutoDefault(false);
    auto* close = new QPushButton(tr("Close"), this);
    close->setObjectName("preferencesClose");
    setRole(*close, "primary");
    close->setAutoDefault(false); // Enter ends typing in a field
    row->addWidget(defaults);
    row->addStretch();
    row->addWidget(close);
    column->addLayout(row);
    connect(defaults, &QPushButton::clicked, this, &PreferencesDialog::restoreDefaults);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
}

/// What the row above is about.
void PreferencesDialog::addNote(QFormLayout* form, const QString& text)
{
    auto* note = new QLabel(text, form->parentWidget());
    note->setProperty("role", "dimmed");
    note->setWordWrap(true);
    note->setContentsMargins(0, 0, 0, 8);
    form->addRow(note);
}

QComboBox* PreferencesDialog::addChoice(QFormLayout* form, const QString& title, const char* name,
                                        const std::vector<Choice>& choices,
                                        std::function<QVariant(const Preferences&)> get,
                                        std::function<void(Preferences&, const QVariant&)> set)
{
    QComboBox* box = makeChoice(name, form->parentWidget());
    for (const Choice& choice : choices)
        box->addItem(choice.text, choice.value);
    form->addRow(title, box);
    m_fillings.push_back(
        [box, get = std::move(get)](const Preferences& p) { box->setCurrentIndex(box->findData(get(p))); });
    connect(box, &QComboBox::currentIndexChanged, this, [this, box, set = std::move(set)](int index) {
        if (index >= 0)
            change([&](Preferences& p) { set(p, box->itemData(index)); });
    });
    return box;
}

QSpinBox* PreferencesDialog::addNumber(QFormLayout* form, const QString& title, const char* name, const QString& suffix,
                                       int least, int most, int Preferences::*member)
{
    auto* box = new QSpinBox(form->parentWidget());
    box->setObjectName(name);
    box->setRange(least, most);
    box->setSuffix(suffix);
    box->setKeyboardTracking(false);
    box->setAlignment(Qt::AlignRight);
    form->addRow(title, box);
    m_fillings.push_back([box, member](const Preferences& p) { box->setValue(p.*member); });
    connect(box, &QSpinBox::valueChanged, this,
            [this, member](int value) { change([&](Preferences& p) { p.*member = value; }); });
    return box;
}

void PreferencesDialog::addSwitch(QFormLayout* form, const QString& text, const char* name, bool Preferences::*member)
{
    auto* box = new QCheckBox(text, form->parentWidget());
    box->setObjectName(name);
    form->addRow(box);
    m_fillings.push_back([box, member](const Preferences& p) { box->setChecked(p.*member); });
    connect(box, &QCheckBox::toggled, this,
            [this, member](bool on) { change([&](Preferences& p) { p.*member = on; }); });
}

void PreferencesDialog::change(const std::function<void(Preferences&)>& edit)
{
    if (m_isFilling)
        return;
    const Preferences before = readPreferences(); // panels choose some of them, too
    m_now = before;
    edit(m_now);
    if (m_now != before)
        emit changed(m_now);
}

/// Of the page of keys, the keys; else all others.
void PreferencesDialog::restoreDefaults()
{
    if (m_index->currentRow() == static_cast<int>(Page::Keys)) {
        m_shortcuts.resetAll();
        return;
    }
    setPreferences({});
    emit changed(m_now);
}

/// The index of pages is a list, which those who make it have to say again.
void PreferencesDialog::changeEvent(QEvent* event)
{
    if ((event->type() == QEvent::LanguageChange || event->type() == QEvent::FontChange) && m_index->count() > 0) {
        const QStringList titles{tr("General"), tr("Memory and safety"), tr("Files"), tr("3D view"), tr("Keys")};
        for (int i = 0; i < m_index->count(); ++i)
            m_index->item(i)->setText(titles[i]);
        m_index->setFixedWidth(m_index->sizeHintForColumn(0) + indexMargin);
    }
    QDialog::changeEvent(event);
}

} // namespace knead
