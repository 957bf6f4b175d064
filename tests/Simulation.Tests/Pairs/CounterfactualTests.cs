using Harvester.Sessions.Labels;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;
using Harvester.TestSupport;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Pairs;

/// <summary>Pictures with and without objects differ in the objects, their shadows and their reflections, and nowhere else.</summary>
public sealed class CounterfactualTests(ITestOutputHelper output)
{
    /// <summary>A few of an object's own pixels may have the colours of what is behind it.</summary>
    private const double MinChanged = 0.9;

    /// <summary>A judge that allows more of a picture than this would not notice much.</summary>
    private const double MaxAllowed = 0.3;

    [Fact]
    [Trait("Category", "Heavy")]
    public void Plain_pictures_differ_only_where_the_object_is() => Judge(4, Detail.Plain, "clear,rain", "0,12", "nearest-vehicle");

    /// <summary>Seeds of towns, each with what is hidden there.</summary>
    public static TheoryData<int, string> Towns
    {
        get
        {
            (int, string)[] inCi = [(15, "nearest-sign,vehicles,nearest-person"), (23, "nearest-vehicle,trafficLight")];
            (int, string)[] others =
            [
                (5, "signs,nearest-vehicle,people"),
                (17, "nearest-vehicle,trafficLight"),
                (30, "signs,nearest-vehicle,people"),
                (49, "nearest-sign,vehicles,nearest-person"),
            ];
            var towns = new TheoryData<int, string>();
            foreach ((int seed, string without) in ProofSize.Of(inCi, [.. inCi, .. others]))
            {
                towns.Add(seed, without);
            }

            return towns;
        }
    }

    [Theory]
    [MemberData(nameof(Towns))]
    [Trait("Category", "Heavy")]
    public void Pictures_differ_only_in_object_shadow_and_reflection(int seed, string without) =>
        Judge(seed, Detail.Full, "clear,thunder,snow,foggy", "0,7,12,18", without);

    private void Judge(int seed, Detail detail, string weathers, string hours, string without)
    {
        PairHarvest harvest = PairHarvest.Of(
            new SimulationOptions
            {
                Seed = seed,
                IsWarm = true,
                IsTimeOfDayFixed = true,
                Detail = detail,
            },
            PairHarvest.Options(weathers, hours, without)
        );
        Assert.Empty(harvest.Warnings);
        int judged = 0;
        foreach (PairLabel pair in harvest.Labels[0].Pairs.Where(pair => pair.Without.Count > 0))
        {
            string name = Path.GetFileNameWithoutExtension(pair.File!);
            string sky = name[..name.IndexOf("-without", StringComparison.Ordinal)];
            bool[] changed = Changed(harvest.Pictures[0][sky == "base" ? "frame" : sky], harvest.Pictures[0][name]);
            var traces = new ObjectTraces(
                harvest.Scenes[0],
                harvest.Drawn!,
                [.. pair.Without.Where(harvest.Handles.ContainsKey).Select(id => harvest.Handles[id])],
                Weather.LightingOf(pair.Weather, new SimulationOptions().DayOfYear, pair.TimeOfDay),
                detail
            );

            int own = 0,
                ownChanged = 0,
                allowed = 0,
                outside = 0;
            for (int pixel = 0; pixel < changed.Length; pixel++)
            {
                own += traces.Object[pixel] ? 1 : 0;
                ownChanged += traces.Object[pixel] && changed[pixel] ? 1 : 0;
                allowed += traces.Allowed[pixel] ? 1 : 0;
                outside += changed[pixel] && !traces.Allowed[pixel] ? 1 : 0;
            }

            output.WriteLine($"{name}: {own} own, {ownChanged} of them changed, {changed.Count(each => each)} changed, {allowed} allowed");
            Assert.True(outside == 0, $"{name}: {outside} pixels differ outside the object, its shadow and its reflection.");
            Assert.InRange((double)ownChanged / own, MinChanged, 1);
            Assert.InRange((double)allowed / changed.Length, 0, MaxAllowed);
            judged++;
        }

        Assert.NotEqual(0, judged);
    }

    private static bool[] Changed(byte[] with, byte[] without) =>
        [.. Enumerable.Range(0, with.Length / 3).Select(pixel => !with.AsSpan(pixel * 3, 3).SequenceEqual(without.AsSpan(pixel * 3, 3)))];
}
