#include "drt/dynamics/contact_world.h"

#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cmath>

#include "drt/base/constants.h"

namespace drt {

namespace {

btVector3 to_bullet(const Vec3d& v) { return {v.x, v.y, v.z}; }
btQuaternion to_bullet(const Quatd& q) { return {q.x, q.y, q.z, q.w}; }
Vec3d from_bullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
btTransform to_bullet(const RigidState& s) { return btTransform(to_bullet(s.orientation), to_bullet(s.position)); }

// Bullet rounds the rims of cylinders by this share of their size.
constexpr double margin = 1e-5;
// Of distances that Bullet finds by iteration (GJK).
constexpr double gjk_error = 1e-8;

std::unique_ptr<btCollisionShape> make_shape(const SphereCollider& c) {
    return std::make_unique<btSphereShape>(c.radius);
}
std::unique_ptr<btCollisionShape> make_shape(const BoxCollider& c) {
    return std::make_unique<btBoxShape>(to_bullet(c.half));
}
std::unique_ptr<btCollisionShape> make_shape(const CylinderCollider& c) {
    auto shape = std::make_unique<btCylinderShapeZ>(btVector3(c.radius, c.radius, c.half_height));
    shape->setMargin(margin * std::min(c.radius, c.half_height));
    return shape;
}
std::unique_ptr<btCollisionShape> make_shape(const PlaneCollider& c) {
    auto shape = std::make_unique<btStaticPlaneShape>(to_bullet(normalize(c.normal)), 0);
    shape->setMargin(0);
    return shape;
}
std::unique_ptr<btCollisionShape> make_shape(const PolygonCollider& c) {
    auto shape = std::make_unique<btConvexHullShape>();
    for (const Vec3d& v : c.vertices) shape->addPoint(to_bullet(v), false);
    shape->recalcLocalAabb();
    shape->setMargin(0);
    return shape;
}
std::unique_ptr<btCollisionShape> make_shape(const DiscCollider& c) {
    constexpr int corners = 64;  // for cylinders and boxes; the largest gap to the circle is 1e-3 of the radius
    const Vec3d n = normalize(c.normal);
    const Vec3d x = normalize(cross(std::abs(n.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}, n)), y = cross(n, x);
    PolygonCollider polygon;
    for (int k = 0; k < corners; ++k) {
        const double angle = 2 * pi<double> * k / corners;
        polygon.vertices.push_back((x * std::cos(angle) + y * std::sin(angle)) * c.radius);
    }
    return make_shape(polygon);
}

class BulletWorld : public ContactWorld {
public:
    explicit BulletWorld(const RigidScene& s) : scene_(s) {
        configuration_.setPlaneConvexMultipointIterations(4, 4);  // a cylinder's face on a plane
        // Contacts are seen from the same distance (farthest_contact), whatever the bodies' sizes.
        dispatcher_.setDispatcherFlags(dispatcher_.getDispatcherFlags() &
                                       ~btCollisionDispatcher::CD_USE_RELATIVE_CONTACT_BREAKING_THRESHOLD);
        for (const RigidBody& b : s.bodies) add(b);
        btContactSolverInfo& info = bullet_.getSolverInfo();
        info.m_numIterations = 1000;
        info.m_leastSquaresResidualThreshold = 1e-26;
        info.m_splitImpulse = 1;
        info.m_splitImpulsePenetrationThreshold = 1e30;                      // positions never change velocities
        info.m_restitutionVelocityThreshold = 0;                             // the simulation's, not Bullet's business
        info.m_solverMode = SOLVER_SIMD | SOLVER_USE_2_FRICTION_DIRECTIONS;  // no warm start
        info.m_timeStep = 1e6;  // in which a gap of rounding's size asks for no speed
    }
    ~BulletWorld() override {
        for (auto& b : bodies_) bullet_.removeRigidBody(b.get());
    }

    Nearest nearest(int a, const RigidState&, int b, const RigidState&) const override;
    std::vector<Contact> contacts(const std::vector<RigidState>&, double reach) override;
    void collide(std::vector<RigidState>&, std::span<const Contact>) override;

private:
    void add(const RigidBody&);
    void place(size_t body, const RigidState&);
    std::vector<std::unique_ptr<btPersistentManifold>> manifolds_of(const Contact&) const;

    const RigidScene& scene_;
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld bullet_{&dispatcher_, &broadphase_, &solver_, &configuration_};
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

void BulletWorld::add(const RigidBody& b) {
    shapes_.push_back(std::visit([](const auto& c) { return make_shape(c); }, b.collider));
    const bool moves = b.kind == RigidBody::Kind::dynamic;
    btRigidBody::btRigidBodyConstructionInfo info(moves ? b.mass : 0, nullptr, shapes_.back().get(),
                                                  moves ? to_bullet(b.inertia) : btVector3(0, 0, 0));
    info.m_startWorldTransform = to_bullet(b.start);
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    btRigidBody& body = *bodies_.back();
    body.setActivationState(DISABLE_DEACTIVATION);
    body.setFlags(0);  // the gyroscopic torque is free flight's business
    // Otherwise the solver takes its velocity for zero.
    if (b.kind == RigidBody::Kind::kinematic)
        body.setCollisionFlags(body.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    body.setUserIndex(int(bodies_.size()) - 1);
    bullet_.addRigidBody(&body);
}

void BulletWorld::place(size_t body, const RigidState& state) {
    btRigidBody& b = *bodies_[body];
    b.setWorldTransform(to_bullet(state));
    b.setInterpolationWorldTransform(b.getWorldTransform());
    b.updateInertiaTensor();
}

Nearest BulletWorld::nearest(int a, const RigidState& sa, int b, const RigidState& sb) const {
    btVoronoiSimplexSolver simplex;
    btGjkEpaPenetrationDepthSolver depth;
    btGjkPairDetector detector(static_cast<const btConvexShape*>(shapes_[size_t(a)].get()),
                               static_cast<const btConvexShape*>(shapes_[size_t(b)].get()), &simplex, &depth);
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA = to_bullet(sa);
    input.m_transformB = to_bullet(sb);
    btPointCollector result;
    detector.getClosestPoints(input, result, nullptr);
    return {result.m_distance, from_bullet(result.m_normalOnBInWorld), from_bullet(result.m_pointInWorld), gjk_error};
}

std::vector<Contact> BulletWorld::contacts(const std::vector<RigidState>& states, double reach) {
    for (size_t i = 0; i < states.size(); ++i) place(i, states[i]);
    for (int i = 0; i < dispatcher_.getNumManifolds(); ++i)  // no memory of earlier contacts
        dispatcher_.clearManifold(dispatcher_.getManifoldByIndexInternal(i));
    bullet_.updateAabbs();
    bullet_.performDiscreteCollisionDetection();
    std::vector<Contact> out;
    for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
        const btPersistentManifold& m = *dispatcher_.getManifoldByIndexInternal(i);
        const bool in_order = m.getBody0()->getUserIndex() < m.getBody1()->getUserIndex();
        Contact c;
        std::tie(c.a, c.b) = std::minmax(m.getBody0()->getUserIndex(), m.getBody1()->getUserIndex());
        for (int k = 0; k < m.getNumContacts(); ++k) {
            const btManifoldPoint& p = m.getContactPoint(k);
            if (p.getDistance() > reach) continue;
            const Vec3d n = from_bullet(p.m_normalWorldOnB);
            Vec3d on_a = from_bullet(p.getPositionWorldOnA()), on_b = from_bullet(p.getPositionWorldOnB());
            if (!in_order) std::swap(on_a, on_b);
            c.all[size_t(c.count++)] = {p.getDistance(), 0, in_order ? n : -n, on_a, on_b, {}};
        }
        out.push_back(c);
    }
    // Bullet's order is that of its broad phase: ours must not depend on where bodies were before.
    std::sort(out.begin(), out.end(),
              [](const Contact& p, const Contact& q) { return std::pair(p.a, p.b) < std::pair(q.a, q.b); });
    return out;
}

// Bullet's manifolds have room for four points each.
std::vector<std::unique_ptr<btPersistentManifold>> BulletWorld::manifolds_of(const Contact& contact) const {
    const RigidBody &a = scene_.bodies[size_t(contact.a)], &b = scene_.bodies[size_t(contact.b)];
    const btRigidBody &in_bullet_a = *bodies_[size_t(contact.a)], &in_bullet_b = *bodies_[size_t(contact.b)];
    std::vector<std::unique_ptr<btPersistentManifold>> out;
    for (int k = 0; k < contact.count; ++k) {
        if (k % MANIFOLD_CACHE_SIZE == 0)  // all its points count, whatever their distance
            out.push_back(std::make_unique<btPersistentManifold>(&in_bullet_a, &in_bullet_b, 0, 1e30, 1e30));
        const ContactPoint& point = contact.all[size_t(k)];
        const btVector3 on_a = to_bullet(point.on_a), on_b = to_bullet(point.on_b);
        btManifoldPoint p(in_bullet_a.getWorldTransform().invXform(on_a),
                          in_bullet_b.getWorldTransform().invXform(on_b), to_bullet(point.normal), point.gap);
        p.m_positionWorldOnA = on_a;
        p.m_positionWorldOnB = on_b;
        p.m_combinedFriction = combined_friction(a, b);
        p.m_combinedRestitution = combined_restitution(a, b);
        out.back()->addManifoldPoint(p);
    }
    return out;
}

void BulletWorld::collide(std::vector<RigidState>& states, std::span<const Contact> contacts) {
    std::vector<int> moved;
    for (const Contact& c : contacts) moved.insert(moved.end(), {c.a, c.b});
    std::sort(moved.begin(), moved.end());
    moved.erase(std::unique(moved.begin(), moved.end()), moved.end());
    std::vector<btCollisionObject*> objects;
    // An impact of twice the speed is twice the same; Bullet makes NaN of some at 1e8.
    double fastest = 0;
    for (const Contact& c : contacts) fastest = std::max(fastest, c.approach());
    const double unit = fastest > 0 ? fastest : 1;
    for (const int k : moved) {
        const RigidState& s = states[size_t(k)];
        place(size_t(k), s);
        btRigidBody& body = *bodies_[size_t(k)];
        body.setLinearVelocity(to_bullet(s.velocity / unit));
        body.setAngularVelocity(to_bullet(s.spin / unit));
        objects.push_back(&body);
    }
    std::vector<std::unique_ptr<btPersistentManifold>> owned;
    for (const Contact& c : contacts)
        for (auto& m : manifolds_of(c)) owned.push_back(std::move(m));
    std::vector<btPersistentManifold*> manifolds;
    for (auto& m : owned) manifolds.push_back(m.get());
    const btContactSolverInfo& info = bullet_.getSolverInfo();
    solver_.prepareSolve(int(objects.size()), int(manifolds.size()));
    solver_.solveGroup(objects.data(), int(objects.size()), manifolds.data(), int(manifolds.size()), nullptr, 0, info,
                       nullptr, &dispatcher_);
    solver_.allSolved(info, nullptr);
    for (const int k : moved) {
        if (scene_.bodies[size_t(k)].kind != RigidBody::Kind::dynamic) continue;
        states[size_t(k)].velocity = from_bullet(bodies_[size_t(k)]->getLinearVelocity()) * unit;
        states[size_t(k)].spin = from_bullet(bodies_[size_t(k)]->getAngularVelocity()) * unit;
    }
}

}  // namespace

}  // namespace drt

extern "C" {
[[gnu::visibility("default")]] drt::ContactWorld* drt_make_contact_world(const drt::RigidScene* scene) {
    return new drt::BulletWorld(*scene);
}
[[gnu::visibility("default")]] const char* drt_contact_world_version() { return drt::contact_world_version; }
}
