#pragma once

#include "core/message/message.h"
#include "core/model/part.h"
#include "core/session/node_places.h"
#include "core/simulation/moment.h"
#include "core/simulation/snapshot.h"
#include "core/task/task_control.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace knead {

/// A body at one moment, for who asks what its material does at nodes.
struct BodyAtNodes {
    std::string name;
    const TriangleMesh* surface = nullptr; ///< of the opened part
    std::shared_ptr<const Aggregate> aggregate;
    std::vector<Vec3> displacements;                             ///< per object, since they were filled [m]
    std::vector<Vec3> velocities;                                ///< per object [m/s]; empty: not known
    std::shared_ptr<const std::vector<BrokenConnection>> broken; ///< null: none
    std::shared_ptr<const RelaxedState> relaxed;                 ///< null: no stress is known
    std::shared_ptr<const std::vector<Vec3>> pressing;           ///< per object [N]; null: not known
    std::vector<ObjectIndex> loaded;                             ///< see SkinStress::stresses()
};

/// All bodies of a snapshot. The model must outlive them.
/// @param partOfBody per body of the snapshot, index into Model::parts
/// @param moment the same moment, for velocities; null: they are not known
std::vector<BodyAtNodes> bodiesAtNodes(const Model& model, std::span<const std::size_t> partOfBody,
                                       const Snapshot& snapshot, const Moment* moment = nullptr);

/// Nodes of another program's mesh.
struct NodesToAsk {
    std::span<const Vec3> nodes; ///< [m]
    NodesAt at = NodesAt::rest;
    NodeCells cells = {}; ///< of them; they say which of two touching bodies a node is of
    std::span<const Vec3> others =
        {}; ///< places that are asked for, too, as integration points of cells [m]; they follow the nodes
};

/// What the material does at nodes. Vectors have one entry per node, or none where the quantity is not known; at nodes outside of all
/// bodies their numbers are NaN. Tensors are in world axes.
struct NodalStates {
    std::vector<std::uint32_t> body;   ///< that the node is of; NodePlace::none: outside of all
    std::vector<double> outside;       ///< distance from the nearest body, 0 in it [m]
    std::vector<Vec3> rest;            ///< X, where it was when the part was opened [m]
    std::vector<Vec3> displacement;    ///< x - X [m]
    std::vector<Vec3> velocity;        ///< [m/s]
    std::vector<Mat3> strain;          ///< Hencky, ln sqrt(F F^T) with F = dx/dX, flow included
    std::vector<Mat3> stress;          ///< Cauchy [Pa]
    std::vector<double> plasticStrain; ///< equivalent, the sum of all flow there and back
    std::vector<Vec3> contactForce;    ///< what presses, shared out to the nodes; their sum is that of the objects [N]
    std::vector<Message> warnings;     ///< sentences for the person
    std::size_t outsideCount = 0;      ///< nodes outside of all bodies
};

/// Displacement goes as the skin does (SkinMap), strain and stress as at the skin (SkinStress): of the quadratic map of the objects
/// around, with no traction left on what is free. Nodes up to a spacing outside of a body get what is at its skin, carried on; those
/// farther off get nothing. Pieces of a broken body go each by themselves. Any thread; uses several.
/// @throws Cancelled
NodalStates nodalStates(std::span<const BodyAtNodes> bodies, const NodesToAsk& asked,
                        TaskControl& control = TaskControl::none());

} // namespace knead
