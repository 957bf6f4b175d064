using System.Text.Json;
using System.Windows.Forms;
using GTA.Hosting;
using GTA.Native;
using Harvester.Capture.Harvesting;
using Harvester.Geometry;
using Harvester.Mod.Tests.Games;
using Harvester.Sessions.Scenes;

namespace Harvester.Mod.Tests;

/// <summary>
/// What a harvest on a busy street asks of the game, and the time that this takes of a tick when natives cost what they were measured to
/// cost.
/// </summary>
[Trait("Category", "Heavy")]
public sealed class HarvestNativeTests
{
    private const int Parked = 20;
    private const int Driven = 20;
    private const int OnFoot = 30;
    private const int Ticks = 400;

    /// <summary>A tick that waits for the world to stand still reads the scene once.</summary>
    private const int ReadingsOfATick = 1;

    /// <summary>A call of a native under 3.6.0 and under the nightlies, as measured, and what is taken for a ray, milliseconds.</summary>
    private const double CallOfRelease = 0.0193;
    private const double CallOfNightly = 0.0014;
    private const double RayCost = 0.02;

    [Fact]
    public void Each_reading_asks_a_ped_once_whether_it_sits_in_a_vehicle()
    {
        // The mod itself asks for the player's vehicle in every tick.
        const int ofPlayer = 3;
        int most = 0;
        using ScriptDriver driver = Harvest(0);
        for (int tick = 0; tick < Ticks; tick++)
        {
            int before = driver.Game.Calls.Count(call => call == Hash.IS_PED_IN_ANY_VEHICLE);
            driver.Tick();
            most = Math.Max(most, driver.Game.Calls.Count(call => call == Hash.IS_PED_IN_ANY_VEHICLE) - before);
            driver.Game.Calls.Clear();
        }

        Assert.InRange(most, ReadingsOfATick * (Driven + OnFoot - 1), (ReadingsOfATick * (Driven + OnFoot)) + ofPlayer);
    }

    [Theory]
    [InlineData(CallOfNightly)]
    [InlineData(CallOfRelease)]
    public void Ticks_of_a_busy_street_keep_to_the_budget(double call)
    {
        var spent = new List<double>();
        double ofTick = 0;
        using ScriptDriver driver = Harvest(call, cost => ofTick += cost);
        for (int tick = 0; tick < Ticks; tick++)
        {
            ofTick = 0;
            driver.Tick();
            spent.Add(ofTick);
        }

        // A harvest that takes frames spends most of the budget in some tick.
        double budget = new HarvestOptions().TickBudgetMilliseconds;
        Assert.InRange(spent.Max(), 0.5 * budget, budget);
    }

    [Fact]
    public void Small_budget_makes_a_frame_take_longer_only()
    {
        (int frames, int discarded) ample = Frames("TickBudget = 1000");
        (int frames, int discarded) small = Frames("TickBudget = 0.3");

        Assert.Equal(0, ample.discarded);
        Assert.Equal(0, small.discarded);
        Assert.InRange(small.frames, 1, ample.frames - 1);
    }

    private static (int Frames, int Discarded) Frames(string budget)
    {
        using ScriptDriver driver = Harvest(CallOfRelease, ini: $"[Harvest]\n{budget}\n");
        driver.Tick(2 * Ticks);
        driver.Press(Keys.J);
        driver.WaitForDisk();
        string session = Path.Combine(Assert.Single(Directory.GetDirectories(driver.Output)), "session.json");
        JsonElement counters = JsonDocument.Parse(File.ReadAllText(session)).RootElement.GetProperty("counters");
        return (counters.GetProperty("captured").GetInt32(), counters.GetProperty("discarded").GetInt32());
    }

    private static ScriptDriver Harvest(double call, Action<double>? spend = null, string ini = "")
    {
        var driver = new ScriptDriver(ini);
        HarvestTests.Street(driver.Game);
        foreach (int i in Enumerable.Range(0, Parked + Driven))
        {
            int vehicle = driver.Game.Add(
                new GameEntity
                {
                    Pool = PoolKind.Vehicles,
                    Name = "premier",
                    Pose = PoseOf(i, 240),
                }
            );
            if (i < Driven)
            {
                driver.Game.Add(
                    new GameEntity
                    {
                        Pool = PoolKind.Peds,
                        Name = "a_m_y_hipster_01",
                        Pose = PoseOf(i, 240),
                        Vehicle = vehicle,
                    }
                );
            }
        }

        foreach (int i in Enumerable.Range(0, OnFoot - 1))
        {
            Pose pose = PoseOf(i, 230);
            driver.Game.Add(
                new GameEntity
                {
                    Pool = PoolKind.Peds,
                    Name = "a_m_y_hipster_01",
                    Pose = pose,
                    Skeleton = new Skeleton(Enumerable.Repeat(pose.Position, Skeleton.Count)),
                }
            );
        }

        driver.Press(Keys.J);
        driver.Tick(20);
        driver.Game.Fault = native =>
        {
            double cost = call + (native == Hash.START_EXPENSIVE_SYNCHRONOUS_SHAPE_TEST_LOS_PROBE ? RayCost : 0);
            driver.Clock.Milliseconds += cost;
            spend?.Invoke(cost);
            return null;
        };
        return driver;
    }

    private static Pose PoseOf(int number, double north) =>
        new(new Vector3D(70 + (6 * (number % 10)), north + (8 * (number / 10)), 0.6), Axes.Identity);
}
