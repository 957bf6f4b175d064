using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Models;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;
using Harvester.Simulation.World;

namespace Harvester.Simulation.Tests.World;

public sealed class PopulationTests
{
    private static readonly ObjectClass[] Driving =
    [
        ObjectClass.Car,
        ObjectClass.Truck,
        ObjectClass.Bus,
        ObjectClass.Motorcycle,
        ObjectClass.Bicycle,
    ];

    [Fact]
    public void Ordinary_world_has_every_class_of_objects()
    {
        SimulatedWorld world = new(new SimulationOptions { Seed = 1 });
        ObjectClass[] present = [.. world.EntitiesNear(Vector3D.Zero, double.PositiveInfinity).Select(entity => entity.Class).Distinct()];
        Assert.Equal(Enum.GetValues<ObjectClass>(), present.Order());
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Most_of_the_traffic_is_cars_and_no_class_is_rare()
    {
        // Of about 200 vehicles; a share of 5 % is missed by half with a probability below 5 %, so three worlds are counted together.
        ObjectClass[] drawn =
        [
            .. Enumerable
                .Range(1, 3)
                .SelectMany(seed =>
                    new SimulatedWorld(new SimulationOptions { Seed = seed }).Vehicles.Skip(1).Select(vehicle => vehicle.Model.Class)
                ),
        ];
        Assert.True(drawn.Length > 300, $"{drawn.Length} vehicles");
        Assert.InRange(drawn.Count(kind => kind == ObjectClass.Car) / (double)drawn.Length, 0.6, 0.82);
        Assert.All(Driving, kind => Assert.InRange(drawn.Count(other => other == kind) / (double)drawn.Length, 0.02, 0.82));
    }

    [Fact]
    public void Two_wheelers_in_traffic_have_riders_above_their_boxes()
    {
        SimulatedWorld world = new(new SimulationOptions { Seed = 1 });
        List<EntityState> entities = world.EntitiesNear(Vector3D.Zero, double.PositiveInfinity);
        EntityState[] ridden = [.. entities.Where(entity => entity.HasRider == true)];
        Assert.NotEmpty(ridden);
        MeshInstance[] drawn = [.. world.MovingNear(Vector3D.Zero, double.PositiveInfinity)];
        foreach (EntityState machine in ridden)
        {
            EntityState rider = Assert.Single(entities, entity => entity.VehicleHandle == machine.Handle);
            MeshInstance body = Assert.Single(drawn, instance => instance.Handle == rider.Handle);
            Assert.Equal((ObjectClass.Rider, machine.Pose, machine.Velocity), (rider.Class, rider.Pose, rider.Velocity));
            Assert.Equal((rider.ModelMin, rider.ModelMax), (body.Mesh.Min, body.Mesh.Max));
            Assert.InRange(rider.ModelMax.Z, machine.ModelMax.Z + 0.2, machine.ModelMax.Z + 1.2);
            Assert.True(rider.ModelMin.Z >= machine.ModelMin.Z, $"The feet of the rider of {machine.Model} are below the ground.");
            Assert.All(
                rider.Skeleton!.Joints,
                joint =>
                    Assert.True(
                        Cuboid.FromModel(rider.ModelMin, rider.ModelMax, rider.Pose).Contains(joint),
                        $"A joint of {machine.Model}'s rider."
                    )
            );
        }
    }

    [Fact]
    public void Parked_two_wheelers_have_no_riders()
    {
        SimulatedWorld world = new(new SimulationOptions { Seed = 1 });
        HashSet<int> driving = [.. world.Vehicles.Select(vehicle => vehicle.Handle)];
        EntityState[] parked =
        [
            .. world
                .EntitiesNear(Vector3D.Zero, double.PositiveInfinity)
                .Where(entity => VehicleClasses.HaveRiders(entity.Class) && !driving.Contains(entity.Handle)),
        ];
        Assert.NotEmpty(parked);
        Assert.All(parked, entity => Assert.False(entity.HasRider));
    }

    [Fact]
    public void Parked_vehicles_leave_the_lane_of_a_sharp_bend_free()
    {
        const double maxIntoLane = 1;
        const double roundness = 0.15; // The road is a polygon; the curve through its corners is not quite a circle.
        double[] reaches = [.. Enumerable.Range(1, 20).SelectMany(ReachesOnRing)];

        Assert.True(reaches.Length > 20, $"{reaches.Length} vehicles on the inside of a ring");
        Assert.InRange(reaches.Max(), maxIntoLane / 4, maxIntoLane + roundness);
    }

    [Fact]
    public void Classes_of_models_are_those_of_the_game()
    {
        // The classes of the game by their numbers, for models whose class the list of exceptions does not decide.
        (string Model, int GameClass)[] known =
        [
            ("rebel2", 9),
            ("tropic", 14),
            ("squalo", 14),
            ("hexer", 8),
            ("cruiser", 13),
            ("tanker", 11),
            ("trailerlogs", 11),
            ("rocoto", 2),
            ("pony", 12),
            ("banshee", 6),
        ];
        Assert.All(
            known,
            pair => Assert.Equal(VehicleClasses.Of(ModelHash.Of(pair.Model), pair.GameClass), ModelCatalogue.Shared[pair.Model].Class)
        );
    }

    /// <summary>
    /// How much farther outward the ends of vehicles parked on the inside of a ring reach than their middles, metres.
    /// </summary>
    private static IEnumerable<double> ReachesOnRing(int seed)
    {
        const double radius = 14;
        const int corners = 44;
        RoadNode[] nodes =
        [
            .. Enumerable
                .Range(0, corners)
                .Select(i => new RoadNode(
                    0,
                    i,
                    new Vector3D(radius * Math.Cos(Math.Tau * i / corners), radius * Math.Sin(Math.Tau * i / corners), 0),
                    string.Empty,
                    RoadNodeFlags.None
                )),
        ];
        RoadLink[] links = [.. nodes.Select((_, i) => new RoadLink(i, (i + 1) % corners, 1, 1, null, RoadLinkFlags.None))];
        SimulatedWorld world = new(
            new SimulationOptions
            {
                Seed = seed,
                Roads = new RoadNetwork(nodes, links),
                TrafficDensity = 0,
                ParkedDensity = 2.5,
                PedestrianDensity = 0,
                IsWarm = true,
            }
        );
        HashSet<int> driving = [.. world.Vehicles.Select(vehicle => vehicle.Handle)];
        foreach (
            EntityState entity in world
                .EntitiesNear(Vector3D.Zero, 50)
                .Where(entity => VehicleClasses.AreVehicles(entity.Class) && !driving.Contains(entity.Handle))
        )
        {
            Vector3D middle = entity.Pose.ToWorld((entity.ModelMin + entity.ModelMax) * 0.5);
            if (Across(middle) < radius)
            {
                double halfWidth = (entity.ModelMax.X - entity.ModelMin.X) / 2;
                yield return new[] { entity.ModelMin.Y, entity.ModelMax.Y }
                    .SelectMany(_ => new[] { entity.ModelMin.X, entity.ModelMax.X }, (y, x) => entity.Pose.ToWorld(new Vector3D(x, y, 0)))
                    .Max(Across)
                    - Across(middle)
                    - halfWidth;
            }
        }

        static double Across(Vector3D place) => Math.Sqrt((place.X * place.X) + (place.Y * place.Y));
    }
}
