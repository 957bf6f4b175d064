using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Tests.Lanes;

/// <summary>
/// Vehicles in lanes and their distances against the simulation's own knowledge of the road it was built with: random cars on the
/// lanes of a closed road, placed by the simulation's truth, not by the library.
/// </summary>
public sealed class VehicleDistanceTests
{
    /// <summary>The required accuracy of distances along the road, metres.</summary>
    private const double ExactMetres = 0.05;

    [Fact]
    [Trait("Category", "Heavy")]
    public void Nearest_vehicle_per_lane_is_the_true_one_in_1000_scenes()
    {
        var game = new SimulatedGame(
            new SimulationOptions
            {
                Roads = Loop.Network(lanes: 3),
                RadiusMetres = 600,
                TrafficDensity = 0,
                PedestrianDensity = 0,
            }
        );
        var observer = new LaneObserver(new RoadCurves(game.Roads), new LaneModel(game.Roads));
        var random = new Random(17);
        int judged = 0;
        for (int scene = 0; scene < 1000; scene++)
        {
            for (int tick = 0; tick < 4; tick++)
            {
                game.Tick(0.05);
            }

            IWorld world = game.Ports.World;
            EgoState ego = world.ReadEgo();
            Vector3D centre = ego.Pose.ToWorld((ego.ModelMin + ego.ModelMax) * 0.5);
            if (game.Truth.Locate(centre, ego.Pose.Axes.Forward) is not { } at)
            {
                continue;
            }

            (TrafficVehicle Vehicle, LanePosition Truth)[] vehicles = [.. Scatter(random, centre, game.Truth)];

            LaneObservation seen = observer.Observe(
                centre,
                Angles.HeadingDegrees(ego.Pose.Axes.Forward),
                10,
                4,
                [.. vehicles.Select(vehicle => vehicle.Vehicle)],
                null
            );

            Assert.Equal(LaneStatus.Known, seen.Status);
            foreach (int lane in (int[])[0, 1, 2])
            {
                double? truth = NearestAhead(vehicles, at, lane);
                double? found = seen
                    .Vehicles.Where(vehicle => !vehicle.IsOncoming && vehicle.Lane == lane)
                    .Select(vehicle => (double?)vehicle.DistanceMetres)
                    .FirstOrDefault();
                if (truth is { } expected && expected < IndicatorCalculator.VehicleRange - 1)
                {
                    Assert.NotNull(found);
                    Assert.Equal(expected, found.Value, ExactMetres);
                    judged++;
                }
            }
        }

        Assert.True(judged > 1000, $"Only {judged} distances were judged.");
    }

    private static IEnumerable<(TrafficVehicle Vehicle, LanePosition Truth)> Scatter(Random random, Vector3D around, RoadTruth truth)
    {
        for (int id = 1; id <= 200; id++)
        {
            Vector3D place = around + new Vector3D((random.NextDouble() - 0.5) * 140, (random.NextDouble() - 0.5) * 140, 0);

            // Somewhere near the road: the direction of the road there is taken from the ground truth, trying all directions.
            double heading = random.NextDouble() * 360;
            Vector3D forward = Axes.FromHeading(heading).Forward;
            LanePosition? found = truth.Locate(place, forward);
            if (found is { Lane: not null } onLane && Math.Abs(onLane.AngleToRoad) < 1)
            {
                yield return (new TrafficVehicle(id, place, heading, 4.5), onLane);
            }
        }
    }

    private static double? NearestAhead((TrafficVehicle Vehicle, LanePosition Truth)[] vehicles, LanePosition car, int lane)
    {
        double? nearest = null;
        foreach ((_, LanePosition vehicle) in vehicles)
        {
            if (vehicle.Road == car.Road && vehicle.AlongRoad == car.AlongRoad && vehicle.Lane == lane)
            {
                double ahead = car.AlongRoad
                    ? vehicle.DistanceAlongRoad - car.DistanceAlongRoad
                    : car.DistanceAlongRoad - vehicle.DistanceAlongRoad;
                nearest = ahead > 0 && (nearest is null || ahead < nearest) ? ahead : nearest;
            }
        }

        return nearest;
    }
}
