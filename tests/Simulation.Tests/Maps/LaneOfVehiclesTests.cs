using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Roads;
using Harvester.Simulation.Settings;
using Harvester.Simulation.Streets;
using Harvester.Simulation.Traffic;
using Harvester.Simulation.World;
using Harvester.TestSupport;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Maps;

/// <summary>The lanes on which vehicles are found by place and direction, compared with the paths that they follow.</summary>
[Trait("Category", "Heavy")]
public sealed class LaneOfVehiclesTests(ITestOutputHelper output)
{
    /// <summary>Seconds of traffic, of which each gives a sample.</summary>
    private const int Seconds = 60;

    /// <summary>
    /// Nearer to an end of its path, the middle of a vehicle may be in the junction already, whose border differs: traffic stops up to this
    /// far before it, metres.
    /// </summary>
    private const double NearEnd = 8;

    /// <summary>
    /// The least share of vehicles in junctions on the way that they take, or on the lanes before and after it, which reach farther on the
    /// map: where ways part or merge, the place does not tell them apart.
    /// </summary>
    private const double MinOnOwnWay = 0.8;

    /// <summary>
    /// The least share of vehicles in junctions on that way or one that parts from it or merges with it. In bends of ring roads with a
    /// junction, the traffic's corner is rounder than the map's.
    /// </summary>
    private const double MinOnSuchWay = 0.92;

    public static TheoryData<int> Seeds => [.. ProofSize.Of([5712], [5711, 5712, 5713])];

    [Theory]
    [MemberData(nameof(Seeds))]
    public void Vehicles_are_on_the_lane_that_they_follow(int seed)
    {
        var world = new SimulatedWorld(new SimulationOptions { Seed = seed });
        var maps = new LaneMaps(new RoadCurves(world.Roads), new LaneModel(world.Roads));
        var paths = new TrafficPaths(Site.OfTown(seed).Lanes);
        (int onRoad, int right, int between, int inJunction, int onWay, int onNeighbour, int onArm) = (0, 0, 0, 0, 0, 0, 0);
        for (int second = 0; second < Seconds; second++)
        {
            world.Advance(1);
            foreach (Vehicle vehicle in world.Vehicles.Where(vehicle => vehicle.Ways.Count() == 1))
            {
                Vector3D forward = vehicle.Pose.Axes.Forward;
                Vector3D centre = vehicle.Pose.ToWorld(new Vector3D(0, 0, 0.5));
                MapLane? lane = maps.Around(centre)!.Index.At(centre, forward);
                LanePath path = vehicle.Path;
                if (path.Junction is not null)
                {
                    inJunction++;
                    (int From, int To) truth = (path.Previous[0].Index, path.Next[0].Index);
                    (int? From, int? To) found =
                        lane is null ? (null, null)
                        : lane.Junction is null ? (paths.Before(lane)?.Index, paths.After(lane)?.Index)
                        : (paths.Before(lane.Predecessors[0])?.Index, paths.After(lane.Successors[0])?.Index);
                    bool isOnWay = found == truth;
                    bool isOnRoad = lane is { Junction: null } && (found.From == truth.From || found.To == truth.To);
                    bool isNeighbour = lane is { Junction: not null } && !isOnWay && (found.From == truth.From || found.To == truth.To);
                    onWay += isOnWay ? 1 : 0;
                    onArm += isOnRoad ? 1 : 0;
                    onNeighbour += isNeighbour ? 1 : 0;
                }
                else if (vehicle.Distance < NearEnd || vehicle.Distance > path.Length - NearEnd)
                {
                    between++;
                }
                else
                {
                    onRoad++;
                    bool isRight =
                        lane is not null
                        && (
                            lane.Junction is null
                                ? paths.Of(lane)?.Index == path.Index
                                // A path of the traffic goes on through junctions of one road.
                                : paths.Of(lane.Predecessors[0])?.Index == path.Index && paths.Of(lane.Successors[0])?.Index == path.Index
                        );
                    right += isRight ? 1 : 0;
                    if (!isRight)
                    {
                        output.WriteLine($"{centre} on {lane?.Id ?? "none"}, {vehicle.Distance:0.0} of {path.Length:0.0} m");
                    }
                }
            }
        }

        output.WriteLine(
            $"{right} of {onRoad} on roads; {onWay} of {inJunction} in junctions on their way, "
                + $"{onArm} on their roads before and after it, {onNeighbour} on one that parts from it or "
                + $"merges with it; {between} near the end of a road"
        );
        Assert.Equal(onRoad, right);
        Assert.InRange(onWay + onArm, MinOnOwnWay * inJunction, inJunction);
        Assert.InRange(onWay + onArm + onNeighbour, MinOnSuchWay * inJunction, inJunction);
    }
}
