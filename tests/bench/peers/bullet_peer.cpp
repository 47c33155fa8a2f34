#include "peers/bullet_peer.h"

#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include <chrono>
#include <memory>

namespace knead {

namespace {

constexpr btScalar timeStep = btScalar(0.002);
constexpr int warmUp = 20; // steps

btVector3 inBullet(const Vec3& v)
{
    return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

/// The caller owns it.
btSoftBody* softBody(const PeerBar& bar, btSoftBodyWorldInfo& world)
{
    std::vector<btVector3> places;
    for (const Vec3& place : bar.places)
        places.push_back(inBullet(place));
    const std::vector<btScalar> masses(places.size(), 1);
    auto* body = new btSoftBody(&world, static_cast<int>(places.size()), places.data(), masses.data());
    for (std::size_t i = 0; i < places.size(); ++i)
        body->m_nodes[static_cast<int>(i)].m_v = inBullet(bar.velocities[i] / timeStep);
    body->m_materials[0]->m_kLST = btScalar(0.5);
    body->m_cfg.piterations = 1;
    body->m_cfg.viterations = 0;
    body->m_cfg.collisions = 0;
    for (const PeerBar::Connection& c : bar.connections)
        body->appendLink(static_cast<int>(c.first), static_cast<int>(c.second));
    return body;
}

} // namespace

double bulletStepTime(const PeerBar& bar, int steps)
{
    btSoftBodyRigidBodyCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btSoftRigidDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
    world.setGravity(btVector3(0, 0, 0));
    world.getWorldInfo().m_gravity.setValue(0, 0, 0);
    const std::unique_ptr<btSoftBody> body(softBody(bar, world.getWorldInfo()));
    world.addSoftBody(body.get());
    for (int step = 0; step < warmUp; ++step)
        world.stepSimulation(timeStep, 0);
    const auto start = std::chrono::steady_clock::now();
    for (int step = 0; step < steps; ++step)
        world.stepSimulation(timeStep, 0);
    const double time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    world.removeSoftBody(body.get());
    return time / steps;
}

} // namespace knead
