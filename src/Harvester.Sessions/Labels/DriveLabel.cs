using Harvester.Geometry;

namespace Harvester.Sessions.Labels;

/// <summary>
/// The action that belongs to a frame of a recorded drive: what its driver answered to the frame, and how the car moved from this frame to
/// the next.
/// </summary>
/// <param name="Driver">Who drove from this frame on.</param>
/// <param name="SpeedMetresPerSecond">Speed at the frame, m/s; 0 or more.</param>
public sealed record DriveLabel(DriverKind Driver, double SpeedMetresPerSecond)
{
    /// <summary>
    /// The controls with which the driver answered the frame, without disturbance; null if it did not answer. Those of the built-in driver
    /// are the ones that it applied first.
    /// </summary>
    public DriveControls? Controls { get; init; }

    /// <summary>Game time from the frame until the answer took effect, seconds; null without an answer.</summary>
    public double? AnswerSeconds { get; init; }

    /// <summary>The controls that moved the car in the first tick after the frame; null if unknown or if no tick followed.</summary>
    public DriveControls? Applied { get; init; }

    /// <summary>Whether a disturbance was added to the steering in the first tick after the frame.</summary>
    public bool IsDisturbed { get; init; }

    /// <summary>
    /// The thirteen indicators by which the driver answered, on a scale of TORCS and in the order of <see cref="IndicatorOrder"/>; null if
    /// it answered by controls.
    /// </summary>
    public IReadOnlyList<double>? Indicators { get; init; }

    /// <summary>The driver's target when it answered; null if it is unknown.</summary>
    public DriveTarget? Target { get; init; }

    /// <summary>How the route leaves the next junction: "left", "straight" or "right"; null if none is near or it is unknown.</summary>
    public string? Route { get; init; }

    /// <summary>Distance to that junction, metres, 0 in it; null without one.</summary>
    public double? RouteMetres { get; init; }

    /// <summary>Acceleration in the tick before the frame, m/s², along the car's right, forward and up; null if unknown.</summary>
    public Vector3D? Acceleration { get; init; }

    /// <summary>Turning rate in the tick before the frame, rad/s, about the car's right, forward and up; null if unknown.</summary>
    public Vector3D? AngularRate { get; init; }

    /// <summary>Number of the frame on the live bridge; null without a bridge.</summary>
    public long? BridgeFrame { get; init; }

    /// <summary>What only a simulated game knows; null in GTA V.</summary>
    public DriveTruth? Truth { get; init; }

    /// <summary>The ticks from this frame to the next one, in their order.</summary>
    public IReadOnlyList<DriveTick> Ticks { get; init; } = [];
}
