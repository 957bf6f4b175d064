using Harvester.Capture.Ports;

namespace Harvester.Driving.Bridge;

/// <summary>
/// What a simulated game knows about a drive beyond the indicators, for rewards, ends of episodes and evaluation. Counters start at 0 with
/// the game or its restart.
/// </summary>
public sealed record DrivingTruth
{
    /// <summary>Distance driven, metres, without repositioning.</summary>
    public required double DrivenMetres { get; init; }

    /// <summary>What the car touches now: "vehicle", "parked" or "pedestrian"; null for nothing.</summary>
    public required string? Collision { get; init; }

    /// <summary>Number of collisions with moving vehicles, with parked vehicles and with pedestrians, in this order.</summary>
    public required IReadOnlyList<int> Collisions { get; init; }

    /// <summary>Whether a part of the car is beyond the lanes of its direction, or the car off the road; false in junctions.</summary>
    public required bool IsOutsideLanes { get; init; }

    /// <summary>Number of the road on which the car is; null in junctions and off all roads.</summary>
    public required int? Road { get; init; }

    /// <summary>Index of its lane, from the left of its direction, from 0; null in junctions and off the lanes of its direction.</summary>
    public required int? Lane { get; init; }

    /// <summary>Whether a part of the car is beyond the markings of its lane; false in junctions.</summary>
    public required bool IsAcrossMarking { get; init; }

    /// <summary>Distance of the car to the right of the centre of its lane, metres; null in junctions and off the lanes.</summary>
    public required double? LaneOffsetMetres { get; init; }

    /// <summary>Angle from the car to its road, radians, positive if the road points to the left; null like the offset.</summary>
    public required double? LaneAngleRadians { get; init; }

    /// <summary>Number of times that a program drove past a red light.</summary>
    public required int RedLightsRun { get; init; }

    /// <summary>Number of times that a program drove past a stop sign without having stopped.</summary>
    public required int StopSignsRun { get; init; }

    /// <summary>Number of times that the game has put the car elsewhere: at the end of the roads, or when it was stuck.</summary>
    public required int Repositioned { get; init; }

    /// <summary>How the route leaves the next junction, or the one in which the car is: "left", "straight" or "right"; null if no
    /// junction is near.</summary>
    public required string? Route { get; init; }

    /// <summary>Distance to that junction, metres, 0 in it; null without one.</summary>
    public required double? RouteMetres { get; init; }

    /// <summary>The traffic light there for the car: "green", "amber" or "red"; null for none, and in the junction.</summary>
    public required string? Light { get; init; }

    /// <summary>Whether a stop sign stands there for the car.</summary>
    public required bool HasStopSign { get; init; }

    /// <summary>The controls that moved the car last; null if it has followed the line of its lane so far.</summary>
    public required DrivingControls? Applied { get; init; }

    /// <summary>Whether the built-in driver drives, not the client.</summary>
    public required bool IsByBuiltInDriver { get; init; }
}
