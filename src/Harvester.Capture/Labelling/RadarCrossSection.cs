using Harvester.Sessions.Scenes;
using Harvester.Sessions.Semantics;

namespace Harvester.Capture.Labelling;

/// <summary>
/// A model of radar cross-sections, plausible and not measured: docs/radar.md has the tables. That of an object is its class's at its
/// front, rear and sides, and less between them; that of surroundings grows with the surface.
/// </summary>
internal static class RadarCrossSection
{
    /// <summary>Part of the cross-section that is left at 45 degrees to front, rear and sides.</summary>
    private const double Least = 0.1;

    /// <summary>The cross-section of an object, m².</summary>
    /// <param name="kind">Its class.</param>
    /// <param name="aspectRadians">Direction from the object to the sensor, from its forward axis, radians.</param>
    public static double Of(ObjectClass kind, double aspectRadians)
    {
        double greatest = GreatestOf(kind);
        if (!HasFaces(kind))
        {
            return greatest;
        }

        // σ(φ) = σ0 (a + (1 - a) cos² 2φ): one at 0, 90 and 180 degrees, a at 45.
        double cosine = Math.Cos(2 * aspectRadians);
        return greatest * (Least + ((1 - Least) * cosine * cosine));
    }

    /// <summary>The cross-section of a square metre of surroundings across the ray, at a right angle to its surface, m².</summary>
    public static double OfSurface(SemanticClass kind) =>
        kind switch
        {
            SemanticClass.Building => 0.5,
            SemanticClass.Fence or SemanticClass.Pole => 1,
            SemanticClass.Vegetation => 0.05,
            SemanticClass.Road or SemanticClass.LaneMarking or SemanticClass.Pavement or SemanticClass.Terrain => 0.002,
            SemanticClass.Water or SemanticClass.Sky => 0,
            _ => 0.1,
        };

    private static double GreatestOf(ObjectClass kind) =>
        kind switch
        {
            ObjectClass.Truck or ObjectClass.Bus or ObjectClass.Trailer => 100,
            ObjectClass.Car => 20,
            ObjectClass.Motorcycle => 4,
            ObjectClass.Bicycle => 1,
            ObjectClass.Pedestrian or ObjectClass.Rider => 0.5,
            ObjectClass.Sign or ObjectClass.TrafficLight => 3,
            _ => 1,
        };

    private static bool HasFaces(ObjectClass kind) =>
        kind
            is ObjectClass.Car
                or ObjectClass.Truck
                or ObjectClass.Bus
                or ObjectClass.Trailer
                or ObjectClass.Motorcycle
                or ObjectClass.Bicycle;
}
