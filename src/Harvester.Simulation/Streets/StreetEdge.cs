using Harvester.Geometry;

namespace Harvester.Simulation.Streets;

/// <summary>One edge of a road at a station.</summary>
/// <param name="Kerb">The border of the asphalt, metres, world.</param>
/// <param name="Edge">The outer border of the pavement, on the level of the asphalt; the kerb where there is none.</param>
/// <param name="Outward">Horizontal unit vector away from the road.</param>
/// <param name="Gap">Depth of the ground below the edge, metres.</param>
internal readonly record struct StreetEdge(Vector3D Kerb, Vector3D Edge, Vector3D Outward, double Gap);
