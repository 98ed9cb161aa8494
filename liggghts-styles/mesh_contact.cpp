// SPDX-License-Identifier: GPL-2.0-or-later
#include "mesh_contact.h"

#include <mpi.h>

#include <algorithm>
#include <vector>

#include "fix_contact_history_mesh.h"
#include "fix_mesh_surface.h"
#include "tri_mesh.h"
#include "vector3.h"

namespace LIGGGHTS {
namespace Cohesion {

using cohesion::Vector3;

namespace {

/// Points of neighbouring triangles nearer than this to each other, over the radius, are one: nodes
/// that triangles share may differ by what the mesh file rounds.
constexpr double same_place = 1e-4;

/// A share of the sides of a triangle from its border from which on a point of its face is none of
/// a neighbour's, too: the engine takes both within 1e-8 (in the units of the script).
constexpr double well_within = 0.01;

/// Where a triangle is nearest to a point.
struct Nearest {
  Vector3 place;
  bool of_face;          // as the engine has it: borders included, with its tolerance
  bool far_from_border;  // of a face and of no other
};

Nearest nearest(TriMesh& mesh, int triangle, int particle, const Vector3& point) {
  constexpr int on_face = 7;  // all barycentric coordinates positive
  double x[3] = {point.x, point.y, point.z}, delta[3] = {}, bary[3] = {};
  int signs;
  mesh.resolveTriSphereContactBary(particle, triangle, 0.0, x, delta, bary, signs, false);
  return {point + Vector3{delta[0], delta[1], delta[2]}, signs == on_face,
          std::min({bary[0], bary[1], bary[2]}) > well_within};
}

bool same(const Vector3& a, const Vector3& b, double radius) {
  return norm(a - b) <= same_place * radius;
}

/// The triangle with this id of which `place` is a point, own, ghost or periodic image; negative:
/// none on this process.
int triangle_at(TriMesh& mesh, int id, int particle, const Vector3& place, double radius) {
  for (int k = 0; k < mesh.map_size(id); k++) {
    const int triangle = mesh.map(id, k);
    if (same(nearest(mesh, triangle, particle, place).place, place, radius)) return triangle;
  }
  return -1;
}

/// Whether the engine keeps a contact of the two.
bool have_contact(FixContactHistoryMesh& contacts, int particle, int id) {
  for (int k = 0; k < contacts.nneighs(particle); k++)
    if (contacts.partner(particle, k) == id) return true;
  return false;
}

}  // namespace

bool carries_contact(FixMeshSurface& fix, int triangle, int particle, double* x, double radius) {
  TriMesh& mesh = *fix.triMesh();
  const Vector3 centre{x[0], x[1], x[2]};
  const Nearest own = nearest(mesh, triangle, particle, centre);
  if (own.far_from_border) return true;

  // All triangles around the place, reached over shared edges. One vector for all calls: this is in
  // the loop over the contacts.
  static thread_local std::vector<int> around;
  around.assign(1, triangle);
  for (std::size_t k = 0; k < around.size(); k++) {
    const int neighbours = std::min(mesh.nNeighs(around[k]), 5);  // that the engine has room for
    for (int n = 0; n < neighbours; n++) {
      const int other =
          triangle_at(mesh, mesh.neighFaces(around[k], n), particle, own.place, radius);
      if (other < 0 || std::find(around.begin(), around.end(), other) != around.end()) continue;
      const Nearest theirs = nearest(mesh, other, particle, centre);
      if (!own.of_face) {
        // A triangle is convex: a place other than the shared one is nearer.
        if (theirs.of_face || !same(theirs.place, own.place, radius)) return false;
      } else if (theirs.of_face && other < triangle && same(theirs.place, own.place, radius) &&
                 have_contact(*fix.contactHistory(), particle, mesh.id(other))) {
        return false;  // the engine, going through the triangles in this order, has called it
      }
      around.push_back(other);
    }
  }
  return true;
}

double* history_before(FixMeshSurface& fix, int triangle, int particle, double* x, double radius,
                       int step_offset, double last_step) {
  TriMesh& mesh = *fix.triMesh();
  FixContactHistoryMesh& contacts = *fix.contactHistory();
  const Vector3 centre{x[0], x[1], x[2]};
  for (int k = 0; k < contacts.nneighs(particle); k++) {
    const int id = contacts.partner(particle, k);
    if (id < 0 || id == mesh.id(triangle)) continue;
    double* const history = contacts.contacthistory(particle, k);
    if (history[step_offset] != last_step) continue;
    for (int image = 0; image < mesh.map_size(id); image++) {
      const Vector3 place = nearest(mesh, mesh.map(id, image), particle, centre).place;
      if (same(nearest(mesh, triangle, particle, place).place, place, radius)) return history;
    }
  }
  return nullptr;
}

}  // namespace Cohesion
}  // namespace LIGGGHTS
