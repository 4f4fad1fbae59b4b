#include "bullet_stepping.h"

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace drt::bench {

namespace {

btVector3 to_bullet(const Vec3d& v) { return {v.x, v.y, v.z}; }

std::unique_ptr<btCollisionShape> make_shape(const Collider& c) {
    if (const auto* s = std::get_if<SphereCollider>(&c)) return std::make_unique<btSphereShape>(s->radius);
    if (const auto* b = std::get_if<BoxCollider>(&c)) return std::make_unique<btBoxShape>(to_bullet(b->half));
    return std::make_unique<btStaticPlaneShape>(to_bullet(std::get<PlaneCollider>(c).normal), 0);
}

const RigidBody& body_of(const btCollisionObject* o) { return *static_cast<const RigidBody*>(o->getUserPointer()); }

btScalar friction(const btCollisionObject* a, const btCollisionObject* b) {
    return combined_friction(body_of(a), body_of(b));
}
btScalar restitution(const btCollisionObject* a, const btCollisionObject* b) {
    return combined_restitution(body_of(a), body_of(b));
}

// drt's rules for what two surfaces have together, in place of Bullet's products. They are global: drt's own room
// `bullet`, which uses the same library, must not meet them.
class SurfaceRules {
public:
    SurfaceRules()
        : friction_(gCalculateCombinedFrictionCallback), restitution_(gCalculateCombinedRestitutionCallback) {
        gCalculateCombinedFrictionCallback = friction;
        gCalculateCombinedRestitutionCallback = restitution;
    }
    ~SurfaceRules() {
        gCalculateCombinedFrictionCallback = friction_;
        gCalculateCombinedRestitutionCallback = restitution_;
    }
    SurfaceRules(const SurfaceRules&) = delete;
    SurfaceRules& operator=(const SurfaceRules&) = delete;

private:
    CalculateCombinedCallback friction_, restitution_;
};

class World {
public:
    World(const RigidScene& scene, double step, const Settings& settings) {
        const auto bounces = [](const RigidBody& b) { return b.restitution > 0; };
        const bool anything_bounces = std::any_of(scene.bodies.begin(), scene.bodies.end(), bounces);
        bullet_.setGravity(to_bullet(scene.gravity));
        if (settings.tuned) tune(scene, anything_bounces);
        for (const RigidBody& b : scene.bodies) {
            btRigidBody& body = add(b);
            if (settings.tuned && anything_bounces) body.setContactProcessingThreshold(0);
            if (settings.tuned) body.setActivationState(DISABLE_DEACTIVATION);
            if (settings.tuned && settings.in_flight && !body.isStaticObject())
                body.setLinearVelocity(body.getLinearVelocity() - to_bullet(scene.gravity * (0.5 * step)));
        }
    }
    ~World() {
        for (auto& b : bodies_) bullet_.removeRigidBody(b.get());
    }

    void advance(double step) { bullet_.stepSimulation(step, 0, step); }

    std::vector<Vec3d> positions() const {
        std::vector<Vec3d> out;
        for (const auto& b : bodies_) {
            const btVector3& p = b->getWorldTransform().getOrigin();
            out.push_back({p.x(), p.y(), p.z()});
        }
        return out;
    }

private:
    void tune(const RigidScene& scene, bool anything_bounces) {
        double lightest = 1e300, heaviest = 0;
        for (const RigidBody& b : scene.bodies) {
            if (b.kind != RigidBody::Kind::dynamic) continue;
            lightest = std::min(lightest, b.mass);
            heaviest = std::max(heaviest, b.mass);
        }
        btContactSolverInfo& info = bullet_.getSolverInfo();
        info.m_numIterations = heaviest > 10 * lightest ? 200 : 50;
        info.m_restitutionVelocityThreshold = 0.02 * std::sqrt(length(scene.gravity));
        if (anything_bounces) info.m_splitImpulsePenetrationThreshold = 1e18;
    }

    btRigidBody& add(const RigidBody& b) {
        const bool moves = b.kind == RigidBody::Kind::dynamic;
        shapes_.push_back(make_shape(b.collider));
        const btRigidBody::btRigidBodyConstructionInfo info(moves ? b.mass : 0, nullptr, shapes_.back().get(),
                                                            moves ? to_bullet(b.inertia) : btVector3(0, 0, 0));
        bodies_.push_back(std::make_unique<btRigidBody>(info));
        btRigidBody& body = *bodies_.back();
        const Quatd& q = b.start.orientation;
        body.setWorldTransform(btTransform(btQuaternion(q.x, q.y, q.z, q.w), to_bullet(b.start.position)));
        body.setInterpolationWorldTransform(body.getWorldTransform());
        body.updateInertiaTensor();
        body.setLinearVelocity(to_bullet(b.start.velocity));
        body.setAngularVelocity(to_bullet(b.start.spin));
        body.setUserPointer(const_cast<RigidBody*>(&b));
        bullet_.addRigidBody(&body);
        return body;
    }

    SurfaceRules rules_;
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld bullet_{&dispatcher_, &broadphase_, &solver_, &configuration_};
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

}  // namespace

std::vector<std::vector<Vec3d>> bullet_positions(const RigidScene& scene, std::span<const double> times, double step,
                                                 const Settings& settings) {
    World world(scene, step, settings);
    std::vector<std::vector<Vec3d>> out;
    long done = 0;
    for (const double t : times) {
        for (; done < std::lround(t / step); ++done) world.advance(step);
        out.push_back(world.positions());
    }
    return out;
}

}  // namespace drt::bench
