#pragma once

#include "ui/document/document.h"

#include <QWidget>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

class QAction;
class QComboBox;
class QMenu;
class QFormLayout;
class QLabel;

namespace knead {

class QuantityField;

/// How time runs and what acts on everything: speed, gravity, damping, the integrator, threads.
class SimulationPanel final : public QWidget {
    Q_OBJECT
public:
    /// @param choosesThreads whether one can say how many threads compute
    SimulationPanel(Document& document, QAction* keepUp, bool choosesThreads, QWidget* parent = nullptr);

    /// @param threads that compute; 0: all that the machine has
    void showThreads(int threads);

    /// The gravity that its switch turns on: as it was last, else that of the earth, downwards [m/s^2].
    Vec3 wantedGravity() const { return m_wantedGravity; }

    /// Its choices as menus. @param window that owns them
    QList<QMenu*> newMenus(QWidget* window) const;

signals:
    void speedChanged(double ratio);
    void threadsChosen(int threads); ///< as in showThreads()

private:
    void makeTimeRows(QFormLayout* form);
    void makeGravityRows(QFormLayout* form);
    void makeTableRows(QFormLayout* form);
    void makeDampingRows(QFormLayout* form);
    void makeStepRows(QFormLayout* form, QAction* keepUp);
    void makeThreadRow(QFormLayout* form);
    void documentChanged(Document::Change what);
    void showState();
    void showGravity(const Vec3& gravity);
    void showTable(const Snapshot& now);
    void showDamping(const Snapshot& now);
    void chooseSpeed(int index);
    void choosePlanet(int index);
    void chooseIntegrator(int index);
    void chooseTable(int index);
    void commitTable(double friction, double adhesion);
    void commitGravity();
    void commitDamping(double Material::*value, double number, const char* name);

    Document& m_document;
    Vec3 m_wantedGravity = {0, 0, -9.81};
    QLabel* m_time = nullptr;
    QLabel* m_step = nullptr;
    QComboBox* m_speed = nullptr;
    QComboBox* m_planet = nullptr;
    std::array<QuantityField*, 3> m_gravity{};
    QComboBox* m_table = nullptr;
    QuantityField* m_tableFriction = nullptr;
    QuantityField* m_tableAdhesion = nullptr;
    QuantityField* m_damping = nullptr;
    QuantityField* m_shapeDamping = nullptr;
    QComboBox* m_integrator = nullptr;
    QLabel* m_integratorReason = nullptr;
    QComboBox* m_threads = nullptr;               ///< null: no such choice
    std::optional<Integrator> m_postedIntegrator; ///< until a snapshot shows it
    std::uint64_t m_gravityRequest = 0;           ///< the last one, which a frame must have seen
    std::uint64_t m_tableRequest = 0;
    std::uint64_t m_dampingRequest = 0;
    std::vector<Material> m_damped; ///< as posted last
};

} // namespace knead
