using Harvester.Geometry;
using Harvester.Sessions.Semantics;

namespace Harvester.Capture.Labelling;

/// <summary>
/// A model of the strength of a LiDAR's return: the reflectivity of the material times the cosine of the angle of incidence, which is
/// Lambert's law. Sensors correct for distance, so it does not count. It is plausible, not measured: docs/rigs.md has the table.
/// </summary>
internal static class LidarIntensity
{
    /// <summary>Reflectivity of what has no entry in the table.</summary>
    private const double Usual = 0.3;

    /// <summary>The intensity of a return, 0 to 1.</summary>
    /// <param name="kind">What was hit.</param>
    /// <param name="direction">Unit direction of the ray.</param>
    /// <param name="normal">Unit normal of the surface to either side, in the same frame; zero if unknown, then the ray counts as square.
    /// </param>
    public static double Of(SemanticClass kind, Vector3D direction, Vector3D normal) =>
        Reflectivity(kind) * (normal == Vector3D.Zero ? 1 : Math.Min(1, Math.Abs(direction.Dot(normal))));

    private static double Reflectivity(SemanticClass kind) =>
        kind switch
        {
            SemanticClass.Road => 0.15,
            SemanticClass.LaneMarking => 0.6,
            SemanticClass.Pavement or SemanticClass.Pedestrian or SemanticClass.Rider => 0.35,
            SemanticClass.Building => 0.4,
            SemanticClass.Vegetation => 0.5,
            SemanticClass.Terrain => 0.25,
            SemanticClass.Water => 0.02,
            SemanticClass.Pole => 0.55,
            SemanticClass.Car or SemanticClass.Truck or SemanticClass.Bus or SemanticClass.Trailer => 0.6,
            SemanticClass.Sign => 0.95,
            _ => Usual,
        };
}
