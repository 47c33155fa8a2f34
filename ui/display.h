#pragma once

#include "ui/frame/workbench.h"
#include "ui/viewport/scene_view.h"

#include <QList>
#include <QObject>

#include <memory>
#include <utility>
#include <vector>

class QAction;
class QActionGroup;
class QMenu;

namespace knead {

/// What a person chose to see, between the actions, the panel and the view: each of them may change it, all of them show it.
/// What is switched on or off is remembered from one start of the program to the next.
class Display final : public QObject {
    Q_OBJECT
public:
    explicit Display(const Workbench& bench);

    QMenu* menu() const { return m_menu; }
    /// For the menu of the view.
    QList<QAction*> edgesAndObjects() const
    {
        return {m_edges, m_openEdges, m_grid, m_warnings, m_objects, m_allObjects};
    }
    const QList<QAction*>& shown() const { return m_shown; } ///< that switch something on or off, in order
    QAction* section() const { return m_section; }
    QAction* flip() const { return m_flip; }
    QAction* compare() const { return m_compare; }
    QActionGroup* shadings() const { return m_shadings; } ///< in the order of Shading
    QActionGroup* colors() const { return m_colors; }
    QAction* automaticRange() const { return m_automatic; } ///< of the colors
    QAction* hatched() const { return m_hatched; }          ///< the cut
    ViewportWidget& view() const { return m_bench.viewport; }

    /// As it was when the program ended.
    void restore();

    /// Objects are seen while they are to be selected, also when nobody chose to see them; that is not remembered.
    void lendObjects(bool on);

    void setQuantity(std::optional<SurfaceQuantity> quantity);
    void setMap(ColorMap map);
    void setShading(Shading shading);
    /// @param range from, to in SI; none: as needed
    void setRange(const std::optional<std::pair<double, double>>& range);

    /// The section plane as a person thinks of it: across an axis, at a place along it.
    struct Section {
        enum class Axis { x, y, z, eye };
        Axis axis = Axis::x;
        bool isFlipped = false; ///< the other side is cut off
        Vec3 direction = Vec3::UnitX();
        double offset = 0; ///< along the direction, from the origin [m]
    };
    const Section& sectionPlane() const { return m_plane; }
    std::pair<double, double> sectionReach() const; ///< offsets that cut the part [m]
    void setSectionAxis(Section::Axis axis);        ///< through the middle of the part
    void setSectionOffset(double offset);

signals:
    void changed();

private:
    QAction* make(const char* name, const QString& text, const char* icon, const QString& keys, const QString& tip);
    void makeActions();
    void makeEdges();
    void connectActions();
    void sayWhyNot();
    void makeColors();
    void makeMaps();
    void makeShadings();
    void makeCuts();
    QActionGroup* makeGroup(const std::vector<std::pair<QByteArray, QString>>& names, const QString& tip);
    void makeMenu();
    void insideToggled();
    void apply();
    void applySection();
    void switchSection(bool on);
    void switchCompare(bool on);
    void switchAutomatic(bool on);
    void setHatched(bool on);
    void follow();
    void contentChanged();

    Workbench m_bench;
    QAction* m_skin = nullptr;
    QAction* m_objects = nullptr;
    QAction* m_allObjects = nullptr;
    QAction* m_connections = nullptr;
    QAction* m_original = nullptr;
    QAction* m_breaks = nullptr;
    QAction* m_edges = nullptr;
    QAction* m_openEdges = nullptr;
    QAction* m_grid = nullptr;
    QAction* m_warnings = nullptr;
    QAction* m_section = nullptr;
    QAction* m_flip = nullptr;
    QAction* m_compare = nullptr;
    QActionGroup* m_shadings = nullptr;
    QActionGroup* m_colors = nullptr;
    QActionGroup* m_maps = nullptr; ///< in the order of colorMapChoices()
    QAction* m_automatic = nullptr;
    QActionGroup* m_axes = nullptr; ///< in the order of Section::Axis
    QAction* m_hatched = nullptr;
    QList<QAction*> m_shown;
    QMenu* m_menu = nullptr;
    Section m_plane;
    std::shared_ptr<const Model> m_opened; ///< see Document::opened()
    Box m_placedIn;                        ///< what the plane was placed in [m]; empty at first
    bool m_isFollowing = false;            ///< actions only show what the view has
    bool m_lendsObjects = false;
};

} // namespace knead
