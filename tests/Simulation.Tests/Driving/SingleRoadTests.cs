using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;

namespace Harvester.Simulation.Tests.Driving;

/// <summary>The ego on one straight road that ends on either side.</summary>
public sealed class SingleRoadTests
{
    private const double Tick = 0.05;
    private const double Spacing = 10;
    private const int Nodes = 41;

    [Fact]
    public void Ego_at_the_end_of_the_only_road_is_put_back_on_it()
    {
        SimulatedGame game = On(slope: 0);
        _ = game.Conduct;
        for (int i = 0; i < 90 / Tick; i++)
        {
            game.Tick(Tick);
        }

        Assert.True(game.Conduct.Repositioned > 0, "The car was not repositioned.");
        Assert.True(game.Conduct.Metres > (Nodes - 1) * Spacing, $"It drove {game.Conduct.Metres} m in all.");
    }

    /// <summary>The built-in driver wants 2 m/s² at most, and a slope of 25 % takes 2.4.</summary>
    [Fact]
    public void Built_in_driver_starts_on_a_steep_road()
    {
        SimulatedGame game = On(slope: 0.25);
        (Vector3D place, Vector3D direction) = game.World.Ego.Path.Line.At(game.World.Ego.Path.Length / 2);
        game.Ports.Car!.Reset(place, Angles.HeadingDegrees(direction));
        for (int i = 0; i < 6 / Tick; i++)
        {
            game.Tick(Tick);
        }

        Assert.True(direction.Z > 0, "The road falls.");
        Assert.True(game.World.Ego.Speed > 5, $"The car drives at {game.World.Ego.Speed} m/s.");
    }

    private static SimulatedGame On(double slope)
    {
        RoadNode[] nodes =
        [
            .. Enumerable
                .Range(0, Nodes)
                .Select(i => new RoadNode(
                    0,
                    i,
                    new Vector3D(0, i * Spacing, 30 + (i * Spacing * slope)),
                    string.Empty,
                    RoadNodeFlags.None
                )),
        ];
        RoadLink[] links = [.. Enumerable.Range(0, Nodes - 1).Select(i => new RoadLink(i, i + 1, 1, 0, null, RoadLinkFlags.None))];
        return new SimulatedGame(
            new SimulationOptions
            {
                Roads = new RoadNetwork(nodes, links),
                TrafficDensity = 0,
                PedestrianDensity = 0,
            }
        );
    }
}
