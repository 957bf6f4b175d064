using Harvester.Sessions.Semantics;

namespace Harvester.Sessions.Lidar;

/// <summary>A point that a LiDAR measured.</summary>
/// <param name="X">To the right of the sensor, metres.</param>
/// <param name="Y">In front of the sensor, metres.</param>
/// <param name="Z">Above the sensor, metres.</param>
/// <param name="Intensity">Modelled strength of the return, 0 to 1.</param>
/// <param name="Column">Number of the firing in the turn, from 0.</param>
/// <param name="Beam">Number of the beam in the rig, from 0.</param>
/// <param name="ObjectId">Id of the object that was hit; 0 for everything that has none.</param>
/// <param name="Class">What was hit.</param>
public readonly record struct LidarPoint(
    float X,
    float Y,
    float Z,
    float Intensity,
    ushort Column,
    ushort Beam,
    ushort ObjectId,
    SemanticClass Class
)
{
    /// <summary>Whether no ray of its own measured the point.</summary>
    public bool IsInterpolated { get; init; }
}
