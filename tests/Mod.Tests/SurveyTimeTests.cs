using System.Windows.Forms;
using GTA.Native;
using Harvester.Simulation.Tests.Faces.Survey;

namespace Harvester.Mod.Tests;

/// <summary>The duration of the survey, in ticks, with the measured cost of native calls. docs/spaces.md has the limit.</summary>
public sealed class SurveyTimeTests
{
    private const double TicksPerSecond = 60;

    /// <summary>Of the 173 models known, 8 are traffic lights.</summary>
    private const int Signs = 165;
    private const int Lights = 8;

    /// <summary>A call of a native under 3.6.0 and under the nightlies, as measured, milliseconds.</summary>
    private const double CallOfRelease = 0.0193;
    private const double CallOfNightly = 0.0014;

    /// <summary>The game's own cost of a ray is unknown; this is assumed, milliseconds.</summary>
    private const double RayCost = 0.02;
    private const double BudgetMilliseconds = 8;
    private static readonly string[] SignShapes = ["plate", "octagon", "triangle", "diamond", "beside", "ahead", "two", "coarse"];
    private static readonly string[] LightShapes = ["prop_traffic_01a", "prop_traffic_01b", "prop_traffic_01d", "prop_traffic_03a"];

    [Theory]
    [InlineData(CallOfRelease, 120)]
    [InlineData(CallOfNightly, 120)]
    public void Survey_of_all_models_takes_a_minute_or_two(double call, double maxSeconds)
    {
        double signs = TicksOfAModel(SignShapes, call);
        double lights = TicksOfAModel(LightShapes, call);
        double seconds = ((Signs * signs) + (Lights * lights)) / TicksPerSecond;

        Assert.True(seconds <= maxSeconds, $"{signs:0.0} ticks a sign, {lights:0.0} a light, {seconds:0} s");
    }

    [Fact]
    public void Rays_of_a_tick_stay_within_the_budget()
    {
        double spent = 0;
        var perTick = new List<double>();
        using ScriptDriver driver = Survey(LightShapes, CallOfRelease, ms => spent += ms);
        while (!IsOver(driver))
        {
            driver.WaitForDisk();
            spent = 0;
            driver.Tick();
            perTick.Add(spent);
        }

        // The last ray, with all its natives, and the calls that the mod makes in every tick come on top: the line and the next model's
        // loading.
        const double onTop = 1;
        Assert.InRange(perTick.Max(), BudgetMilliseconds, BudgetMilliseconds + onTop);
    }

    private static double TicksOfAModel(string[] shapes, double call)
    {
        using ScriptDriver driver = Survey(shapes, call, _ => { });
        int ticks = 0;
        while (!IsOver(driver))
        {
            // The ticks are counted of a disk that keeps up, whatever else this machine does.
            driver.WaitForDisk();
            driver.Tick();
            ticks++;
        }

        return (double)ticks / shapes.Length;
    }

    /// <summary>A survey of shapes under the names of models, begun, whose folder is open.</summary>
    private static ScriptDriver Survey(string[] shapes, double call, Action<double> spend)
    {
        string[] names = [.. shapes.Select((_, i) => "prop_test_" + i)];
        var driver = new ScriptDriver($"[Signs]\nModels = {string.Join(", ", names)}\n");
        foreach ((string name, string shape) in names.Zip(shapes))
        {
            driver.Game.Props[name] = KnownProps.All[shape];
        }

        driver.Press(Keys.Multiply);
        driver.WaitForDisk();
        driver.Game.Fault = native =>
        {
            double cost = call + (native == Hash.START_EXPENSIVE_SYNCHRONOUS_SHAPE_TEST_LOS_PROBE ? RayCost : 0);
            driver.Clock.Milliseconds += cost;
            spend(cost);
            return null;
        };
        return driver;
    }

    private static bool IsOver(ScriptDriver driver) =>
        driver.Game.Notifications.Any(message => message.Contains("models are surveyed", StringComparison.Ordinal));
}
