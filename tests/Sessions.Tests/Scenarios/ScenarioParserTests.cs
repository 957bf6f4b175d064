using Harvester.Sessions.Scenarios;

namespace Harvester.Sessions.Tests.Scenarios;

public class ScenarioParserTests
{
    private const string Small = """
        {"name":"s","kind":"k","parameters":{"gap":{"min":10,"max":20},"speed":[8,10]},"ego":{"speed":"$speed"},
        "actors":[{"id":"a","type":"vehicle","start":{"metresAhead":"$gap*2-1","lane":"left"}}],
        "events":[{"id":"e","actor":"a","when":{"all":[{"seconds":1}]},"do":{"action":"brake","acceleration":6}}]}
        """;

    [Fact]
    public void Terms_have_the_values_of_parameters()
    {
        ScenarioTemplate template = ScenarioParser.Read(Small).Template!;

        Scenario drawn = template.Drawn(7);

        Assert.Equal((drawn.Values["gap"] * 2) - 1, drawn.Actors[0].Start.MetresAhead, 12);
        Assert.Equal(drawn.Values["speed"], drawn.Ego.Speed);
        Assert.InRange(drawn.Values["gap"], 10, 20);
        Assert.True(drawn.Values["speed"] is 8 or 10);
    }

    [Fact]
    public void Seeds_spread_over_the_range_and_repeat()
    {
        ScenarioParameter gap = new("gap", 10, 20);
        double[] values = [.. Enumerable.Range(1, 200).Select(gap.Drawn)];

        Assert.Equal(values, Enumerable.Range(1, 200).Select(gap.Drawn));
        Assert.InRange(values.Average(), 14.3, 15.7);
        Assert.True(values.Min() < 10.5 && values.Max() > 19.5);
    }

    [Fact]
    public void Value_of_a_parameter_does_not_depend_on_others()
    {
        Scenario both = ScenarioParser.Read(Small).Template!.Drawn(3);
        Scenario one = ScenarioParser
            .Read(Small.Replace("\"speed\":[8,10]", "\"speed\":[8,9,10,11]", StringComparison.Ordinal))
            .Template!.Drawn(3);

        Assert.Equal(both.Values["gap"], one.Values["gap"]);
    }

    [Fact]
    public void Drawn_scenario_is_written_and_read_back()
    {
        Scenario drawn = ScenarioParser.Read(Small).Template!.Drawn(7);

        ScenarioReading again = ScenarioParser.Read(ScenarioJson.Of(drawn));

        Assert.Empty(again.Problems);
        Assert.Equal(ScenarioJson.Of(drawn), ScenarioJson.Of(again.Template!.Drawn(99)));
    }

    [Theory]
    [InlineData("\"min\":10,\"max\":20", "\"min\":10,\"max\":900", "actors[0].start.metresAhead must be a number from -300 to 300.")]
    [InlineData("$gap*2-1", "$gab", "actors[0].start.metresAhead must be a number from -300 to 300.")]
    [InlineData("\"lane\":\"left\"", "\"lane\":\"up\"", "actors[0].start.lane must be one of ego, left, right, oncoming, not 'up'.")]
    [InlineData("\"actor\":\"a\"", "\"actor\":\"b\"", "events[0].actor must be the id of an actor, not 'b'.")]
    [InlineData("\"seconds\":1", "\"begun\":\"f\"", "event 'e': 'f' is not another event.")]
    [InlineData("\"kind\":\"k\"", "\"kind\":\"k\",\"colour\":1", "colour is not a field of a scenario. Correct its name or delete it.")]
    [InlineData("\"acceleration\":6", "\"degrees\":6", "events[0].do.degrees is not a field of a scenario. Correct its name or delete it.")]
    [InlineData("\"min\":10,\"max\":20", "\"min\":30,\"max\":20", "parameters.gap must be a range whose min is not above its max.")]
    public void Problem_names_its_field(string from, string to, string problem)
    {
        ScenarioReading reading = ScenarioParser.Read(Small.Replace(from, to, StringComparison.Ordinal));

        Assert.Null(reading.Template);
        Assert.Contains(problem, reading.Problems);
    }
}
