#pragma once
// Contact of bodies with flat faces: boxes, and flat polygons as boxes without thickness. Bullet has no use for bodies
// that do not overlap yet (its box-box test finds nothing then), and rounds the others' corners to its hull grid
// (1e-4 of the size): a stack creeps. These are exact.

#include <vector>

#include "drt/dynamics/rigid_body.h"

namespace drt {

/// In world coordinates.
struct Polytope {
    struct Face {
        Vec3d normal;           ///< outwards, unit
        std::vector<int> loop;  ///< of vertices
    };
    std::vector<Vec3d> vertices;
    std::vector<Face> faces;
    std::vector<Vec3d> edges;  ///< directions, unit, parallel ones once
};

bool has_flat_faces(const Collider&);
Polytope make_polytope(const Collider&, const RigidState&);  ///< of a collider with flat faces

/// The direction in which two polytopes are farthest apart, by the separating axis theorem (Gottschalk et al. 1996).
/// Their distance is not less than `distance`; 0 when they just touch.
struct Separation {
    double distance = 0;                 ///< negative: how deep they overlap
    Vec3d normal;                        ///< unit, from b towards a
    int face_of_a = -1, face_of_b = -1;  ///< the face whose normal it is; neither: it is perpendicular to two edges
};
Separation separate(const Polytope& a, const Polytope& b);
/// Where two edges keep apart faces that are almost parallel: by the face. Two boxes on each other touch at several
/// points, of which the axes alone show one.
Separation prefer_faces(const Polytope& a, const Polytope& b, const Separation&);

inline constexpr int most_surface_points = 8;  ///< the corners of two rectangles' overlap
struct SurfacePoint {
    double gap = 0;
    Vec3d on_a, on_b;
};

/// The corners of a body with flat faces, or the rims of a cylinder, near a plane: points on the body and on
/// the plane.
std::vector<SurfacePoint> contact_points(const Collider&, const RigidState&, const PlaneCollider&, const RigidState&,
                                         double reach);

/// Where the two are nearer than `reach`: the corners of the overlap of the faces that look at each other, or the
/// crossing of two edges. The first few are far apart.
std::vector<SurfacePoint> contact_points(const Polytope& a, const Polytope& b, const Separation&, double reach);

/// Where a cylinder or a disc is near a body that is not a ball or a plane: where a flat side of one faces a flat side
/// of the other, or a cylinder lies along one. `normal`: unit, from b towards a, where they are nearest. None
/// elsewhere: then they are near each other at that one place only. The rims count as polygons of sixteen corners.
std::vector<SurfacePoint> contact_points_of_round(const Collider& a, const RigidState&, const Collider& b,
                                                  const RigidState&, const Vec3d& normal, double reach);

}  // namespace drt
