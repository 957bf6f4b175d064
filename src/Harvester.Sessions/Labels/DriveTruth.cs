namespace Harvester.Sessions.Labels;

/// <summary>What a simulated game knows about a recorded drive at a frame. Counters start at 0 with the game.</summary>
/// <param name="DrivenMetres">Distance driven, metres, without repositioning.</param>
/// <param name="IsOutsideLanes">Whether a part of the car is beyond the lanes of its direction; false in junctions.</param>
/// <param name="HasStopSign">Whether a stop sign stands at the next junction for the car.</param>
public sealed record DriveTruth(double DrivenMetres, bool IsOutsideLanes, bool HasStopSign)
{
    /// <summary>What the car touches: "vehicle", "parked" or "pedestrian"; null for nothing.</summary>
    public string? Collision { get; init; }

    /// <summary>Distance of the car to the right of the centre of its lane, metres; null in junctions and off the lanes.</summary>
    public double? LaneOffsetMetres { get; init; }

    /// <summary>Angle from the car to its road, radians, positive if the road points to the left; null like the offset.</summary>
    public double? LaneAngleRadians { get; init; }

    /// <summary>The traffic light at the next junction for the car: "green", "amber" or "red"; null for none.</summary>
    public string? Light { get; init; }

    /// <summary>Number of times that a program drove past a red light.</summary>
    public int RedLightsRun { get; init; }

    /// <summary>Number of times that a program drove past a stop sign without having stopped.</summary>
    public int StopSignsRun { get; init; }

    /// <summary>Number of times that the game has put the car elsewhere.</summary>
    public int Repositioned { get; init; }
}
