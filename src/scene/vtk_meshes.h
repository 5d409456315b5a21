#pragma once

#include "scene/surfaces.h"

class vtkPolyData;

namespace bodkin::scene {

// A mesh in VTK's format, with the arrays "normals" and "openness" of points, and back. to_mesh() reads only
// triangles, throws InputError for an invalid corner, and computes normals and openness if their arrays are missing.
void to_poly_data(const SceneMesh& mesh, vtkPolyData& data);
SceneMesh to_mesh(vtkPolyData& data);

// Computes normals of points: the mean of those of their triangles, weighted by area.
void find_normals(SceneMesh& mesh);

}  // namespace bodkin::scene
