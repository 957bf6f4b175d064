using System.Globalization;
using Harvester.Geometry;

namespace Harvester.Simulation.Tests.World;

/// <summary>A place where a lane cannot be driven.</summary>
/// <param name="Kind">What is wrong.</param>
/// <param name="Place">Where, metres, world.</param>
/// <param name="Metres">How much: the height of the ground above the lane, of the obstacle above it, or the free distance ahead.</param>
internal readonly record struct LaneFault(LaneFaultKind Kind, Vector3D Place, double Metres)
{
    public override string ToString() =>
        string.Create(CultureInfo.InvariantCulture, $"{Kind} at {Place.X:F1},{Place.Y:F1},{Place.Z:F1}: {Metres:F2} m");
}
