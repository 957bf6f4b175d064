using Harvester.Geometry;
using Harvester.Sessions.Faces;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.Faces.Survey;

/// <summary>A shape with the faces that it truly has.</summary>
/// <param name="Shape">The shape that rays hit.</param>
/// <param name="Bones">Where the bones of its heads are.</param>
/// <param name="Faces">The front rectangle of each face, from the lower left to the upper right, and where it looks.</param>
internal sealed record Prop(Mesh Shape, IReadOnlyList<Vector3D> Bones, IReadOnlyList<(Vector3D Min, Vector3D Max, Facing Facing)> Faces);
