using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.Runs.Evaluation.Figures;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Traffic;

namespace Harvester.Runs.Driving;

/// <summary>Reads what the frames of a simulated game say beyond the indicators.</summary>
public static class TruthReader
{
    /// <summary>Reads the current state.</summary>
    /// <param name="game">The game.</param>
    /// <param name="isByBuiltInDriver">Whether its built-in driver drives, not the client.</param>
    public static DrivingTruth Of(SimulatedGame game, bool isByBuiltInDriver)
    {
        EgoState ego = game.Ports.World.ReadEgo();
        EgoConduct conduct = game.Conduct;
        TrueLane lane = TrueLane.Of(game.Truth, ego);
        LanePlacement? inLane = lane.Placement is { Lane: not null } placement ? placement : null;
        return new DrivingTruth
        {
            DrivenMetres = conduct.Metres,
            Collision = conduct.Contact is { } contact ? NameOf(contact) : null,
            Collisions = conduct.Collisions,
            IsOutsideLanes = lane.Placement?.IsBeyondLanes ?? false,
            Road = lane.Placement is { Road: >= 0 } onRoad ? onRoad.Road : null,
            Lane = inLane?.Lane,
            IsAcrossMarking = lane.Placement is { } at && (at.IsOverLeft || at.IsOverRight),
            LaneOffsetMetres = inLane?.RightOfCentre,
            LaneAngleRadians = inLane is null ? null : lane.Angle,
            RedLightsRun = conduct.RedLightsRun,
            StopSignsRun = conduct.StopSignsRun,
            Repositioned = conduct.Repositioned,
            Route = conduct.Turn is { } turn ? NameOf(turn) : null,
            RouteMetres = conduct.MetresToTurn,
            Light = conduct.Light is { } light ? NameOf(light) : null,
            HasStopSign = conduct.HasStopSign,
            Applied = ego.Motion is { Steering: { } steering, Throttle: { } throttle, Brake: { } brake }
                ? new DrivingControls(steering, throttle, brake)
                : null,
            IsByBuiltInDriver = isByBuiltInDriver,
        };
    }

    private static string NameOf(EgoContact contact) =>
        contact switch
        {
            EgoContact.Vehicle => "vehicle",
            EgoContact.Parked => "parked",
            EgoContact.Pedestrian => "pedestrian",
            _ => throw new ArgumentOutOfRangeException(nameof(contact)),
        };

    private static string NameOf(RouteTurn turn) =>
        turn switch
        {
            RouteTurn.Left => "left",
            RouteTurn.Straight => "straight",
            RouteTurn.Right => "right",
            _ => throw new ArgumentOutOfRangeException(nameof(turn)),
        };

    private static string? NameOf(LightState light) =>
        light switch
        {
            LightState.Green => "green",
            LightState.Amber => "amber",
            LightState.Red => "red",
            _ => null,
        };
}
