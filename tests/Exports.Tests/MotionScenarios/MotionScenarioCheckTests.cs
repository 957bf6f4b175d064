using Harvester.TestSupport;

namespace Harvester.Exports.Tests.MotionScenarios;

public sealed class MotionScenarioCheckTests(SimulatedSession simulated) : CheckTests(simulated, "gpudrive")
{
    private const string Scenario = "train/0000_0000.json";

    [Theory]
    [InlineData("^\\{", "", "invalid JSON at ")]
    [InlineData(
        "\"geometry\":\\[\\{\"x\":[^,]*",
        "\"geometry\":[{\"x\":1e9",
        "x of a point is 1000000000, which is not from -1000000 to 1000000."
    )]
    [InlineData("\"valid\":\\[true,", "\"valid\":[", "the lists of an object have different lengths.")]
    [InlineData("\"type\":\"vehicle\"", "\"type\":\"tank\"", "its scenario 0 is not that of line 2 of scenarios.csv.")]
    [InlineData("\"scenario_id\":\"", "\"scenario_id\":\"x", "its scenario 0 is not that of line 2 of scenarios.csv.")]
    [InlineData("\"sdc_track_index\":\\d+", "\"sdc_track_index\":9999", "the recording car is track 9999, which is not among ")]
    [InlineData(
        "(\"type\":\"lane\",\"map_element_id\":\\d,\"id\":)(\\d+)(.*?\"type\":\"lane\",\"map_element_id\":\\d,\"id\":)\\d+",
        "${1}${2}${3}${2}",
        "two parts of the map have the id "
    )]
    public void Damaged_scenarios_are_found(string pattern, string replacement, string expected) =>
        AssertDamageIsFound(Scenario, pattern, replacement, $"{Scenario}: {expected}");

    [Theory]
    [InlineData("frames.csv", "^train", "test", "frames.csv, line 2: its split or time is invalid.")]
    [InlineData("frames.csv", "^train,.*\n", "", "export.json: it counts 7 frames in train, but the dataset has 6.")]
    [InlineData("scenarios.csv", ",train,", ",", "scenarios.csv, line 2: it has 7 columns, not 8.")]
    [InlineData("scenarios.csv", "^train.*\n", "", "train/0000_0000.json: it is not in scenarios.csv.")]
    public void Damaged_tables_are_found(string file, string pattern, string replacement, string expected) =>
        AssertDamageIsFound(file, pattern, replacement, expected);

    [Fact]
    public void Missing_scenarios_are_found() => AssertLossIsFound(Scenario, $"{Scenario}: it is missing, but scenarios.csv lists it.");
}
