using Harvester.Geometry;
using Harvester.Geometry.Lanes;

namespace Harvester.Driving.Bridge;

/// <summary>What is sent with an image.</summary>
/// <param name="Frame">Number of the frame, from 0.</param>
/// <param name="TimeSeconds">The game's time, seconds.</param>
/// <param name="SpeedMetresPerSecond">The car's speed, m/s.</param>
/// <param name="Position">The car's origin, metres, world.</param>
/// <param name="HeadingDegrees">Degrees counter-clockwise from north, in [0, 360).</param>
/// <param name="Indicators">The indicators in metres and radians, on the road as it is.</param>
/// <param name="TorcsEquivalent">The indicators that a road of TORCS would give, with the angle at the car.</param>
/// <param name="IsFast">Whether more than 60 m of straight road lie ahead.</param>
public sealed record BridgeState(
    long Frame,
    double TimeSeconds,
    double SpeedMetresPerSecond,
    Vector3D Position,
    double HeadingDegrees,
    LaneIndicators Indicators,
    LaneIndicators TorcsEquivalent,
    bool IsFast
)
{
    /// <summary>Whether the lanes are known. In junctions and off the road they are not, and all indicators are inactive.</summary>
    public bool AreLanesKnown { get; init; }

    /// <summary>
    /// Whether the client has asked for this frame, by a step or a request. It is then sent even if the client has not answered the last
    /// frame.
    /// </summary>
    public bool IsAskedFor { get; init; }

    /// <summary>Whether an image belongs to the frame; a client may ask for frames without.</summary>
    public bool HasPicture { get; init; } = true;

    /// <summary>What only a simulated game knows; null in GTA V.</summary>
    public DrivingTruth? Truth { get; init; }
}
