using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Models;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;
using Harvester.Simulation.Tests.Models;
using Harvester.Simulation.Tests.Rendering;
using Harvester.Simulation.Traffic;
using Harvester.Simulation.World;

namespace Harvester.Simulation.Tests.Traffic;

public sealed class VehicleLightsTests
{
    private const double Step = 0.1;

    [Theory]
    [InlineData(2)]
    [InlineData(6)]
    [InlineData(7)]
    [InlineData(8)]
    [InlineData(10)]
    [Trait("Category", "Heavy")]
    public void Brake_lights_follow_the_speeds_of_the_vehicles(int seed)
    {
        // Between these changes of speed, both answers are right: the engine slows a vehicle too, and the lamps stay on for a moment.
        // A step is two ticks of 0.05 s. If a vehicle brakes in one of them, by 0.5 m/s² or more, and gains speed in the other, by at most
        // 2 m/s², its speed changes by at most 0.05 s * (2 - 0.5) m/s² = 0.075 m/s.
        const double clearlySlower = -0.15;
        const double clearlyFaster = 0.075;
        SimulatedWorld world = new(new SimulationOptions { Seed = seed });
        Dictionary<int, double> before = [];
        Dictionary<int, int> faster = [];
        int braking = 0,
            driving = 0;
        for (int i = 0; i < 200; i++)
        {
            world.Advance(Step);
            foreach (EntityState vehicle in Vehicles(world))
            {
                double speed = vehicle.Velocity.Length;
                double change = before.TryGetValue(vehicle.Handle, out double last) ? speed - last : 0;
                faster[vehicle.Handle] = change > clearlyFaster ? faster.GetValueOrDefault(vehicle.Handle) + 1 : 0;
                if (i > 0 && (change < clearlySlower || speed == 0))
                {
                    braking++;
                    Assert.True(vehicle.Lights!.Value.Brake, $"{vehicle.Model} slows from {last} to {speed} without brake lights.");
                }
                else if (faster[vehicle.Handle] > 5)
                {
                    driving++;
                    Assert.False(vehicle.Lights!.Value.Brake, $"{vehicle.Model} shows brake lights while it gains speed.");
                }

                before[vehicle.Handle] = speed;
            }
        }

        Assert.True(braking > 500 && driving > 500, $"{braking} and {driving} cases");
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Indicators_blink_to_the_side_of_the_coming_turn()
    {
        const double clearTurn = 0.9;
        SimulatedWorld world = new(new SimulationOptions { Seed = 2 });
        Dictionary<int, List<(double Heading, VehicleLights Lights)>> tracks = [];
        for (int i = 0; i < 300; i++)
        {
            world.Advance(Step);
            foreach (EntityState vehicle in Vehicles(world))
            {
                Vector3D forward = vehicle.Pose.Axes.Forward;
                (tracks.TryGetValue(vehicle.Handle, out var track) ? track : tracks[vehicle.Handle] = []).Add(
                    (Math.Atan2(forward.Y, forward.X), vehicle.Lights!.Value)
                );
            }
        }

        int turns = 0,
            wrong = 0;
        const int around = 20;
        foreach (List<(double Heading, VehicleLights Lights)> track in tracks.Values)
        {
            for (int i = around; i + around < track.Count; i += around)
            {
                double turned = Math.IEEERemainder(track[i + around].Heading - track[i].Heading, 2 * Math.PI);
                if (Math.Abs(turned) is < clearTurn or > 2)
                {
                    continue;
                }

                turns++;
                VehicleLights[] shown = [.. track[(i - around)..(i + around)].Select(moment => moment.Lights)];
                bool blinksThere =
                    shown.Any(lights => turned > 0 ? lights.Left : lights.Right)
                    && shown.Any(lights => turned > 0 ? !lights.Left : !lights.Right);
                wrong += blinksThere ? 0 : 1;
            }
        }

        // Roads with sharp bends of their own, which are no turns at a junction, are few.
        Assert.True(turns > 12, $"{turns} turns");
        Assert.InRange(wrong, 0, turns / 10);
        Assert.True(tracks.Values.Average(track => track.Count(moment => moment.Lights.Left && moment.Lights.Right)) == 0);
    }

    [Fact]
    public void Indicators_blink_with_their_frequency()
    {
        // In one second of 1.5 Hz, a lamp is lit for half of it.
        const double seconds = 40;
        SimulatedWorld world = new(new SimulationOptions { Seed = 2 });
        Vehicle vehicle = world.Vehicles.Skip(1).First(vehicle => Enumerable.Range(0, 100).Any(time => Lit(vehicle, time / 100.0)));
        bool[] lit = [.. Enumerable.Range(0, (int)(seconds * 100)).Select(time => Lit(vehicle, time / 100.0))];
        int starts = Enumerable.Range(1, lit.Length - 1).Count(i => lit[i] && !lit[i - 1]);
        Assert.InRange(starts / seconds, VehicleSignals.BlinkHertz - 0.05, VehicleSignals.BlinkHertz + 0.05);
        Assert.InRange(lit.Count(on => on) / (double)lit.Length, 0.47, 0.53);
    }

    [Fact]
    public void Headlights_shine_when_it_is_dark()
    {
        SimulatedWorld world = new(new SimulationOptions { Seed = 2 });
        Assert.All(Vehicles(world), vehicle => Assert.False(vehicle.Lights!.Value.Head));
        world.IsDark = true;
        Assert.All(Vehicles(world), vehicle => Assert.True(vehicle.Lights!.Value.Head));
    }

    [Fact]
    public void Light_of_every_lamp_lies_within_the_box_of_its_vehicle()
    {
        VehicleLights all = new(true, true, true, true);
        foreach (Model model in ModelCatalogueTests.Catalogue.Vehicles)
        {
            if (model.Lamps!.Of(all) is { } mesh)
            {
                Assert.True(
                    mesh.Min.X >= model.Min.X
                        && mesh.Min.Y >= model.Min.Y
                        && mesh.Min.Z >= model.Min.Z
                        && mesh.Max.X <= model.Max.X
                        && mesh.Max.Y <= model.Max.Y
                        && mesh.Max.Z <= model.Max.Z,
                    model.Name
                );
            }
        }
    }

    /// <summary>From behind: brake lights on both sides, indicators on the side that is indicated and not on the other.</summary>
    [Fact]
    [Trait("Category", "Heavy")]
    public void Lamps_are_seen_from_behind_where_they_belong()
    {
        const int fewest = 8;
        foreach (
            Model model in ModelCatalogueTests.Catalogue.Vehicles.Where(model =>
                model.Class is ObjectClass.Car or ObjectClass.Truck or ObjectClass.Bus or ObjectClass.Trailer
            )
        )
        {
            RenderTarget dark = FromBehind(model, default);
            Assert.True(Changed(dark, FromBehind(model, new(true, false, false, false)), left: true) >= fewest, $"{model.Name} brake");
            Assert.True(Changed(dark, FromBehind(model, new(true, false, false, false)), left: false) >= fewest, $"{model.Name} brake");
            RenderTarget indicated = FromBehind(model, new(false, true, false, false));
            Assert.True(Changed(dark, indicated, left: true) >= fewest, $"{model.Name} left");
            Assert.Equal(0, Changed(dark, indicated, left: false));
        }
    }

    private static bool Lit(Vehicle vehicle, double time)
    {
        VehicleLights lights = vehicle.Signals.At(vehicle, time, false);
        return lights.Left || lights.Right;
    }

    private static IEnumerable<EntityState> Vehicles(SimulatedWorld world)
    {
        HashSet<int> driving = [.. world.Vehicles.Select(vehicle => vehicle.Handle)];
        return world.EntitiesNear(Vector3D.Zero, double.PositiveInfinity).Where(entity => driving.Contains(entity.Handle));
    }

    private static RenderTarget FromBehind(Model model, VehicleLights lights)
    {
        var camera = TestScene.Camera with { VerticalFovDegrees = 20 };
        var pose = new Pose(new Vector3D(0, 20 - model.Min.Y, -1.4 - model.Min.Z), Axes.Identity);
        List<MeshInstance> instances = [new(model.Mesh, pose, 1)];
        if (model.Lamps!.Of(lights) is { } lamps)
        {
            instances.Add(new(lamps, pose, 1));
        }

        return TestScene.Render(camera, [.. instances]);
    }

    /// <summary>The pixels on one side of the picture's middle that became clearly brighter.</summary>
    private static int Changed(RenderTarget before, RenderTarget after, bool left)
    {
        const int clearly = 40;
        return Enumerable
            .Range(0, before.Handles.Length)
            .Count(pixel =>
                (pixel % before.Width < before.Width / 2) == left && after.Colour[pixel * 3] - before.Colour[pixel * 3] > clearly
            );
    }
}
