using Harvester.Sessions.Plans;

namespace Harvester.Sessions.Tests.Plans;

public sealed class TrialTests
{
    private const string Text = """
        {"name":"p","seed":7,"places":[{"name":"a","x":0,"y":0},{"name":"b","x":9,"y":9}],"weathers":["rain","clear"],
        "hours":["08:30","21:00"],"cameras":[{"name":"c"},{"name":"d"}],"repetitions":2}
        """;

    [Fact]
    public void Repetition_changes_fastest_and_place_slowest()
    {
        string[] ids = [.. TrialsOf(Text).Select(trial => trial.Id)];

        Assert.Equal(2 * 2 * 2 * 2 * 2, ids.Distinct().Count());
        Assert.Equal(["a_rain_0830_c_001", "a_rain_0830_c_002", "a_rain_0830_d_001", "a_rain_0830_d_002", "a_rain_2100_c_001"], ids[..5]);
        Assert.Equal(["a_clear_0830_c_001", "b_rain_0830_c_001"], [ids[8], ids[16]]);
    }

    [Fact]
    public void Trials_keep_id_and_seed_when_others_are_added()
    {
        string longer = Text.Replace("""["rain",""", """["snow","rain",""", StringComparison.Ordinal);
        var seeds = TrialsOf(longer).ToDictionary(trial => trial.Id, trial => trial.SeedOf(7, 1));

        Assert.All(TrialsOf(Text), trial => Assert.Equal(trial.SeedOf(7, 1), seeds[trial.Id]));
    }

    [Fact]
    public void Every_trial_and_attempt_has_a_seed_of_its_own()
    {
        int[] seeds = [.. TrialsOf(Text).SelectMany(trial => Enumerable.Range(1, 3).Select(attempt => trial.SeedOf(7, attempt)))];

        Assert.Equal(seeds.Length, seeds.Distinct().Count());
        Assert.All(seeds, seed => Assert.InRange(seed, 0, int.MaxValue));
    }

    [Fact]
    public void Seed_is_the_fnv_hash_of_plan_seed_and_id()
    {
        // FNV-1a of "7/a_rain_0830_c_001" by an independent program (Python), without the highest bit.
        const int known = 158167;
        Assert.Equal(known, TrialsOf(Text)[0].SeedOf(7, 1));
    }

    private static IReadOnlyList<Trial> TrialsOf(string text)
    {
        Plan plan = PlanParser.Read(text).Plan!;
        return TrialList.Of(plan, plan.Places);
    }
}
