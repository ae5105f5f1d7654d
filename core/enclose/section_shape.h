// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/enclose/contact.h"
#include "core/meshing/meshing.h"

namespace cagewright {

// What the cross sections have to be where they stay in their slides' planes: quadrilaterals with corners near to right
// angles. It asks for nothing of the sections that are released: all of them where `in_plane` is false, and
// those that are not whole.
class SectionShape {
 public:
  // `most_off` (radians): of a corner's angle from a right angle. Borrows `sections`.
  SectionShape(const Cage& cage, const std::vector<SectionFrame>& sections, bool in_plane, double most_off);

  // Unit normals of the planes that vertices stay in; zero: free.
  const Points& plane_normals() const { return normals_; }
  int section_of(int vertex) const { return sections_of_[static_cast<std::size_t>(vertex)]; }
  // Row of corner i. Precondition: the section is whole.
  int corner(int section, int i) const {
    return corners_[static_cast<std::size_t>(section)][static_cast<std::size_t>(i)];
  }
  int section_count() const { return static_cast<int>(sections_.size()); }
  bool is_released(int section) const { return is_released_[static_cast<std::size_t>(section)] != 0; }
  void release(int section);
  // Takes a release back; the section has to be in its plane and sound again.
  void hold(int section);
  bool is_whole(int section) const { return corner(section, 0) >= 0; }

  // Moves the corners into their planes, exactly but for rounding.
  void put_in_plane(Points& points) const;
  // The same of those that are `chosen`, of each vertex.
  void put_in_plane(Points& points, const std::vector<char>& chosen) const;
  // The same, and where a section is not sound: the nearest rectangle along the frame's p and q.
  void put_in_shape(Points& points) const;
  bool is_sound(int section, const Points& points) const;
  // Largest deviation from a right angle over all sections in plane, radians.
  double most_off(const Points& points) const;
  // Conditions on a step, to first order, that keep all sections sound.
  void add_contacts(const Points& points, Contacts& contacts) const;

 private:
  std::array<double, 4> angles(int section, const Points& points) const;

  const std::vector<SectionFrame>& sections_;
  std::vector<char> is_released_;
  double most_off_;
  std::vector<int> sections_of_;
  std::vector<std::array<int, 4>> corners_;  // of each section
  Points normals_;
};

}  // namespace cagewright
