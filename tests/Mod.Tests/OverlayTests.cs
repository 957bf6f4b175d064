using System.Globalization;
using System.Text.RegularExpressions;
using System.Windows.Forms;
using GTA.Hosting;
using Harvester.Geometry;
using Harvester.Mod.Tests.Games;

namespace Harvester.Mod.Tests;

/// <summary>What the overlay costs in native calls, each of which takes about 20 microseconds on release 3.6.0 of the API.</summary>
public sealed class OverlayTests
{
    /// <summary>Without roads, so that neither their survey nor lane lines count.</summary>
    private const string NoRoads = "[Roads]\nFile = none.csv\n";
    private const int NativesPerEntity = 6;

    /// <summary>In every tick the mounted camera checks whether its vehicle exists and the player is in it.</summary>
    private const int NativesOfTheMount = 4;
    private const int Ticks = 120;

    [Fact]
    public void Tick_of_the_overlay_calls_fewer_than_six_natives_per_entity()
    {
        using var driver = new ScriptDriver(NoRoads, faces: LightTests.TableOfOne);
        int seen = Fill(driver.Game);
        driver.Press(Keys.I);
        driver.Press(Keys.L);
        driver.UntilMessage("Reading the roads failed");
        driver.Tick();
        Assert.Equal(4 * seen, driver.Game.Rectangles.Count);

        int most = 0;
        int before = driver.Game.Calls.Count;
        for (int tick = 0; tick < Ticks; tick++)
        {
            int beforeTick = driver.Game.Calls.Count;
            driver.Tick();
            most = Math.Max(most, driver.Game.Calls.Count - beforeTick);
        }

        Assert.InRange(driver.Game.Calls.Count - before, 4 * seen * Ticks, (NativesPerEntity * seen * Ticks) - 1);
        Assert.InRange(most, 4 * seen, (NativesPerEntity * seen) - 1 + NativesOfTheMount);
    }

    [Fact]
    public void Log_reports_the_natives_called_per_tick_of_the_overlay()
    {
        using var driver = new ScriptDriver(NoRoads, faces: LightTests.TableOfOne);
        int seen = Fill(driver.Game);
        driver.Press(Keys.I);
        driver.UntilMessage("Reading the roads failed");
        driver.Press(Keys.L);
        driver.Tick(Ticks);
        driver.Press(Keys.L);

        Match figures = Regex.Match(
            driver.Log(),
            @"The overlay: off after (\d+) ticks in .* s, ([\d.]+) natives per tick, 0 rays per second, tick time p50 "
        );
        Assert.InRange(int.Parse(figures.Groups[1].Value, CultureInfo.InvariantCulture), Ticks, Ticks + 2);
        Assert.InRange(double.Parse(figures.Groups[2].Value, CultureInfo.InvariantCulture), 4 * seen, NativesPerEntity * seen);
    }

    [Fact]
    public void Box_follows_its_car_in_every_tick_until_it_is_deleted()
    {
        using var driver = new ScriptDriver(NoRoads);
        HarvestTests.Street(driver.Game);
        GameEntity car = driver.Game.Vehicles.Single(vehicle => vehicle.Name == "premier");
        driver.Press(Keys.I);
        driver.Press(Keys.L);
        double last = double.PositiveInfinity;
        for (int tick = 0; tick < 30; tick++)
        {
            car.Pose = car.Pose with { Position = car.Pose.Position + new Vector3D(0, 1, 0) };
            driver.Tick();
            double width = driver.Game.Rectangles.Take(4).Aggregate((all, side) => all.Union(side)).Width;
            Assert.True(width < last, "The box stays behind.");
            last = width;
        }

        driver.Game.Entities.Remove(driver.Game.HandleOf(car));
        driver.Tick();
        Assert.Equal(4, driver.Game.Rectangles.Count);
    }

    /// <summary>Eight objects to be seen, and a dozen that cannot be: behind the camera, or sitting in a car.</summary>
    private static int Fill(TestGame game)
    {
        HarvestTests.Street(game);
        int ahead = game.HandleOf(game.Vehicles.Single(vehicle => vehicle.Name == "premier"));
        Add(PoolKind.Vehicles, "stanier", 96, 230);
        Add(PoolKind.Vehicles, "bus", 104, 260);
        Add(PoolKind.Vehicles, "bati", 97, 240);
        Add(PoolKind.Peds, "a_m_y_hipster_01", 107, 240);
        game.Add(LightTests.LightAt(new Vector3D(108, 250, 0), Axes.Identity));
        game.Add(LightTests.LightAt(new Vector3D(92, 250, 0), Axes.Identity));
        game.Add(
            new GameEntity
            {
                Pool = PoolKind.Peds,
                Name = "a_m_y_hipster_01",
                Pose = new Pose(new Vector3D(100, 220, 1), Axes.Identity),
                Vehicle = ahead,
            }
        );
        for (int behind = 0; behind < 11; behind++)
        {
            Add(PoolKind.Vehicles, "asea", 98 + behind, 180 - behind);
        }

        return 8;

        void Add(PoolKind pool, string name, double x, double y) =>
            game.Add(
                new GameEntity
                {
                    Pool = pool,
                    Name = name,
                    Pose = new Pose(new Vector3D(x, y, 0.6), Axes.Identity),
                }
            );
    }
}
