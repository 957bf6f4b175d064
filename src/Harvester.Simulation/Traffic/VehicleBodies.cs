using Harvester.Geometry;
using Harvester.Simulation.Crashes;
using Harvester.Simulation.Models;

namespace Harvester.Simulation.Traffic;

/// <summary>Vehicles as rigid bodies on the ground.</summary>
internal static class VehicleBodies
{
    /// <summary>The body of a vehicle at rest at a place.</summary>
    public static PlanarBody At(Model model, Footprint place)
    {
        PlanarBody body = VehicleMass.BodyOf(model, place.HalfLength, place.HalfWidth);
        body.Position = Flat(place.Centre);
        body.Yaw = Math.Atan2(place.Forward.Y, place.Forward.X);
        return body;
    }

    /// <summary>A vector without its height.</summary>
    public static Vector2D Flat(Vector3D vector) => new(vector.X, vector.Y);
}
