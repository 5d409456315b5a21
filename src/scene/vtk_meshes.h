#pragma once

#include "scene/surfaces.h"

class vtkPolyData;

namespace bodkin::scene {

// A mesh as VTK has it, with the arrays "normals" and "openness" of points, and back. to_mesh() reads triangles only,
// throws InputError where a corner is no point, and finds normals and openness itself where their arrays are missing.
void to_poly_data(const SceneMesh& mesh, vtkPolyData& data);
SceneMesh to_mesh(vtkPolyData& data);

// Normals of points: the mean of those of their triangles, weighted by area.
void find_normals(SceneMesh& mesh);

}  // namespace bodkin::scene
