#include "peers/lammps_peer.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <stdexcept>
#include <string>

namespace knead {

namespace {

// Units of LAMMPS: the spacing, the mass of an object, and a connection's stiffness of 1000. At this step it is as stable as
// Knead at its own.
constexpr double stiffness = 1000;
constexpr double timeStep = 0.002;
constexpr double radius = 0.75; // neighbors along axes and diagonals touch, others do not
constexpr int warmUp = 20;      // steps

std::string dataOf(const PeerBar& bar, LammpsWork work)
{
    const bool spheres = work == LammpsWork::bondsAndContacts;
    std::string data = "A bar of spheres on a lattice\n\n" + std::to_string(bar.places.size()) + " atoms\n" +
                       std::to_string(bar.connections.size()) + " bonds\n1 atom types\n2 bond types\n\n";
    Box box;
    for (const Vec3& place : bar.places)
        box.extend(place);
    const char* const axes = "xyz";
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const std::string name(1, axes[axis]);
        data += std::to_string(box.min()[axis] - 12) + " " + std::to_string(box.max()[axis] + 12) + " " + name + "lo " +
                name + "hi\n";
    }
    data += spheres ? "\nAtoms\n\n" : "\nMasses\n\n1 1\n\nAtoms\n\n";
    const double density = 1 / (4 * std::numbers::pi / 3 * radius * radius * radius);
    const auto text = [](const Vec3& v) {
        return std::to_string(v.x()) + " " + std::to_string(v.y()) + " " + std::to_string(v.z());
    };
    for (std::size_t i = 0; i < bar.places.size(); ++i)
        data += std::to_string(i + 1) + (spheres ? " 1 " + text(bar.places[i]) + " " + std::to_string(2 * radius) +
                                                       " " + std::to_string(density) + " 1\n"
                                                 : " 1 1 " + text(bar.places[i]) + "\n");
    data += "\nVelocities\n\n";
    for (std::size_t i = 0; i < bar.velocities.size(); ++i)
        data += std::to_string(i + 1) + " " + text(bar.velocities[i] / timeStep) + (spheres ? " 0 0 0\n" : "\n");
    data += "\nBonds\n\n";
    std::size_t number = 0;
    for (const PeerBar::Connection& c : bar.connections)
        data += std::to_string(++number) + (c.isDiagonal ? " 2 " : " 1 ") + std::to_string(c.first + 1) + " " +
                std::to_string(c.second + 1) + "\n";
    return data;
}

/// The law of a bond of some length: E = K (r - r0)^2. Where contacts push bonded spheres apart, half of the stiffness is
/// theirs, and bonds are so much shorter that the bar is at rest.
std::string bondLaw(LammpsWork work, int type, double length)
{
    const bool shared = work == LammpsWork::bondsAndContacts;
    return "bond_coeff " + std::to_string(type) + " " + std::to_string(shared ? stiffness / 4 : stiffness / 2) + " " +
           std::to_string(shared ? 2 * length - 2 * radius : length) + "\n";
}

std::string inputOf(LammpsWork work, const std::filesystem::path& data, int steps)
{
    const bool contacts = work == LammpsWork::bondsAndContacts;
    std::string input = "units lj\n";
    input += contacts ? "atom_style hybrid sphere bond\n" : "atom_style bond\n";
    input += "boundary s s s\nnewton on\ncomm_modify vel yes cutoff 4.0\n";
    input += contacts ? "special_bonds lj/coul 1 1 1\n" : "special_bonds lj/coul 0 1 1\n";
    input += "read_data " + data.string() + " extra/special/per/atom 2\n";
    input += "bond_style harmonic\n" + bondLaw(work, 1, 1) + bondLaw(work, 2, std::numbers::sqrt2);
    if (contacts)
        input += "pair_style gran/hooke " + std::to_string(stiffness / 2) + " NULL 2 1 0.3 0\npair_coeff * *\n";
    else
        input += "pair_style soft " + std::to_string(2 * radius) + "\npair_coeff * * 300\n";
    input += "neighbor 0.3 bin\nneigh_modify every 1 delay 0 check yes one 200 page 20000\n";
    input += contacts ? "fix 1 all nve/sphere\n" : "fix 1 all nve\n";
    input += "timestep " + std::to_string(timeStep) + "\nthermo 1000000\n";
    input += "run " + std::to_string(warmUp) + "\nrun " + std::to_string(steps) + "\n";
    return input;
}

void write(const std::filesystem::path& file, const std::string& text)
{
    std::ofstream stream(file);
    stream << text;
    if (!stream.flush())
        throw std::runtime_error(file.string() + " could not be written.");
}

/// Of the last run in a log: "Loop time of 1.2 on 1 procs for 100 steps with 3400 atoms".
double loopTime(const std::filesystem::path& log)
{
    std::ifstream stream(log);
    double time = 0;
    for (std::string line; std::getline(stream, line);)
        if (line.starts_with("Loop time of "))
            time = std::strtod(line.c_str() + 13, nullptr);
    if (!(time > 0))
        throw std::runtime_error("LAMMPS did not run to its end; see " + log.string());
    return time;
}

} // namespace

double lammpsStepTime(const PeerBar& bar, LammpsWork work, int processes, int steps,
                      const std::filesystem::path& folder)
{
    const std::string name = work == LammpsWork::bondsAndContacts ? "contacts" : "bonds";
    const std::filesystem::path data = folder / (name + ".data");
    const std::filesystem::path input = folder / (name + ".in");
    const std::filesystem::path log = folder / (name + ".log");
    write(data, dataOf(bar, work));
    write(input, inputOf(work, data, steps));
    std::filesystem::remove(log);
    const std::string mpi = "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun --oversubscribe -np ";
    const std::string command = (processes > 1 ? mpi + std::to_string(processes) + " " : std::string()) + "lmp -in '" +
                                input.string() + "' -log '" + log.string() + "' -screen none";
    if (std::system(command.c_str()) != 0)
        throw std::runtime_error("LAMMPS failed; see " + log.string());
    return loopTime(log) / steps;
}

} // namespace knead
