using Harvester.Datasets.Roads;
using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;
using Harvester.Simulation.Streets;
using Harvester.TestSupport;

namespace Harvester.Simulation.Tests;

/// <summary>Drives on the game's own roads.</summary>
[Trait("Category", "Heavy")]
public sealed class RealStreetsTests
{
    [RealWorldFact("nodes.zip")]
    public void Ego_drives_within_its_lane_outside_junctions()
    {
        RoadNetwork network = RoadImporter.Import(RealWorldFactAttribute.PathOf("nodes.zip")!).Network;
        double outsideMetres = 0;
        foreach (Vector2D near in new Vector2D[] { new(0, -1000), new(0, 200), new(1000, -1500), new(2000, 3000), new(-1500, -400) })
        {
            outsideMetres += Drive(
                new SimulatedGame(
                    new SimulationOptions
                    {
                        Roads = network,
                        Near = near,
                        TrafficDensity = 0,
                        PedestrianDensity = 0,
                    }
                )
            );
        }

        Assert.True(outsideMetres > 4000, $"Only {outsideMetres:F0} m driven outside junctions.");
    }

    /// <returns>Metres driven outside junctions.</returns>
    private static double Drive(SimulatedGame game)
    {
        const double tickSeconds = 0.1;
        double outsideMetres = 0;
        for (int tick = 0; tick < 3000; tick++)
        {
            game.Tick(tickSeconds);
            EgoState ego = game.Ports.World.ReadEgo();
            LanePosition? position = game.Truth.Locate(ego.Pose.Position, ego.Pose.Axes.Forward);
            Assert.True(position is not null, $"The car is on no road at {ego.Pose.Position}.");
            if (!position.IsInJunction)
            {
                outsideMetres += ego.Velocity.Length * tickSeconds;
                Assert.NotNull(position.Lane);

                // Lanes are driven as polylines of 0.5 m: in a bend of 6 m radius the chord is 0.5²/(8·6) = 5 mm off.
                Assert.InRange(position.RightOfLaneCentre, -0.02, 0.02);
            }
        }

        return outsideMetres;
    }
}
